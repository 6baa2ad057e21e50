// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "model/modulestate.h"

class QLabel;

namespace nmc {

class GlyphLabel;

/// A module without a panel of its own: what it says it is, and its status byte. Read only.
class GenericPanel : public QWidget {
    Q_OBJECT

public:
    explicit GenericPanel(QWidget* parent = nullptr);
    void showModule(const ModuleState& module);

private:
    QLabel* m_name;
    QLabel* m_text;
    QLabel* m_status;
};

}  // namespace nmc
