// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "widgets/panels/panelview.h"

class QLabel;
class QPushButton;

namespace nmc {

class Requests;

/// A module that no data sheet here covers: what it reports to be, and its status byte. It is only monitored,
/// because the effect of other commands is unknown.
class GenericPanel : public QWidget {
    Q_OBJECT

public:
    explicit GenericPanel(Requests& requests, QWidget* parent = nullptr);
    /// Emits nothing.
    void showModule(const PanelView& view);

private:
    QLabel* m_name;
    QLabel* m_text;
    QLabel* m_status;
    QPushButton* m_ask;
    ModuleIndex m_module;
};

}  // namespace nmc
