// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>

class QRadioButton;

namespace nmc {

/// The four kinds of motion of a PIC-STEP, as a choice.
class StepperModeChoice : public QWidget {
    Q_OBJECT

public:
    enum class Mode : std::uint8_t { Trapezoid, Profile, TimedMove, TimedRun };

    explicit StepperModeChoice(QWidget* parent = nullptr);

    [[nodiscard]] Mode mode() const;
    /// Emits nothing.
    void showMode(Mode mode);

    /// True if the motion has a ramp.
    [[nodiscard]] bool profiled() const { return mode() == Mode::Trapezoid || mode() == Mode::Profile; }
    [[nodiscard]] bool hasGoal() const { return mode() == Mode::Trapezoid || mode() == Mode::TimedMove; }

signals:
    void chosen();

private:
    std::array<QRadioButton*, 4> m_buttons{};
};

}  // namespace nmc
