// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <optional>

#include "widgets/panels/panelview.h"

class QLabel;
class QPushButton;

namespace nmc {

class GlyphLabel;

/// Head of a module's panel: who it is, what it does in shape and word, where it is in large digits, and the
/// controls that switch and stop this one motor.
class PanelHead : public QFrame {
    Q_OBJECT

public:
    enum class Drive : std::uint8_t { Servo, Stepper };

    /// The names of a stepper's controls begin with "step": stepEnableButton.
    explicit PanelHead(Drive drive, QWidget* parent = nullptr);

    /// Emits nothing.
    void showModule(const PanelView& view);
    /// Enable waits for the module's next word; stops never wait.
    void setBusy(bool busy);

signals:
    void intentRequested(const nmc::Intent& intent);

private:
    [[nodiscard]] QString named(const QString& name) const;
    QPushButton* addButton(const QString& icon, const QString& text, const QString& objectName,
                           const QString& accessibleName, Intent intent);
    void refresh();
    void showPosition(const PanelView& view);

    Drive m_drive;
    GlyphLabel* m_glyph;
    QLabel* m_name;
    QLabel* m_type;
    QLabel* m_state;
    QLabel* m_meaning;
    QLabel* m_position;
    QLabel* m_positionUnit;
    QLabel* m_otherPosition;
    QLabel* m_home;
    QPushButton* m_enable;
    QPushButton* m_stopSmoothly;
    QPushButton* m_stopAbruptly;
    QPushButton* m_stopHere;
    QPushButton* m_motorOff;
    std::optional<ModuleState> m_module;
    bool m_connected = false;
    bool m_on = false;
    bool m_busy = false;
};

}  // namespace nmc
