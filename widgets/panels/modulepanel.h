// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStackedWidget>
#include <optional>

#include "model/intent.h"

class QLabel;

namespace nmc {

class GenericPanel;
class ServoPanel;

/// The middle of the window: the panel that fits the selected module, or what to do when there is none.
class ModulePanel : public QStackedWidget {
    Q_OBJECT

public:
    explicit ModulePanel(QWidget* parent = nullptr);

    void showModule(const ModuleState& module, bool connected, std::optional<double> age);
    /// No module: `text` says why and what to do.
    void showNothing(const QString& text);
    [[nodiscard]] ServoPanel* servoPanel() const { return m_servo; }

private:
    /// Only the page in sight decides how much room is needed.
    void bringUp(QWidget* page);

    QLabel* m_empty;
    ServoPanel* m_servo;
    GenericPanel* m_generic;
};

}  // namespace nmc
