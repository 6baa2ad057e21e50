// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <functional>
#include <optional>

#include "model/intent.h"

class QLabel;
class QPushButton;

namespace nmc {

class GlyphLabel;

/// Head of a module's panel: who it is, what it does in shape and word, where it is in large digits, and the
/// controls that switch and stop this one motor.
class PanelHead : public QFrame {
    Q_OBJECT

public:
    using WhyNot = std::function<std::optional<Refusal>(Request)>;

    enum class Drive : std::uint8_t { Servo, Stepper };

    /// The names of a stepper's controls begin with "step": stepEnableButton.
    explicit PanelHead(Drive drive, QWidget* parent = nullptr);

    /// `age`: how old the value is when it is too old to be trusted, s; else empty.
    void showModule(const ModuleState& module, const WhyNot& whyNot, std::optional<double> age);
    /// Enable waits for the module's next word; stops never wait.
    void setBusy(bool busy);

signals:
    void intentRequested(const nmc::Intent& intent);

private:
    [[nodiscard]] QString named(const QString& name) const;
    QPushButton* addButton(const QString& icon, const QString& text, const QString& objectName,
                           const QString& accessibleName, Intent intent);
    void refresh();
    void showPosition(const ModuleState& module, std::optional<double> age);

    Drive m_drive;
    GlyphLabel* m_glyph;
    QLabel* m_name;
    QLabel* m_type;
    QLabel* m_state;
    QLabel* m_position;
    QLabel* m_positionUnit;
    QPushButton* m_enable;
    QPushButton* m_stopSmoothly;
    QPushButton* m_stopAbruptly;
    QPushButton* m_motorOff;
    WhyNot m_whyNot;
    bool m_on = false;
    bool m_busy = false;
};

}  // namespace nmc
