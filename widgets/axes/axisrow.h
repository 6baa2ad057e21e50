// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>

#include "widgets/panels/modulecontext.h"

class QGridLayout;
class QLabel;

namespace nmc {

class Command;
class HoldButton;
class Requests;

/// Speed at which axes are jogged from the table of all axes.
enum class JogSpeed : std::uint8_t {
    Slow,  ///< the jog speed of the axis
    Fast,  ///< the jog speed cap of the axis
};

/// One axis in the table of all axes: position, state, hold to move, and steps.
class AxisRow : public QObject {
    Q_OBJECT

public:
    AxisRow(const PanelView& view, Requests& requests, int line, QGridLayout& grid, QWidget* box);

    void show(const PanelView& view);
    /// `step`: in the axis's own unit. `place`: in the homing order, from 1; 0 if the axis has no homing
    /// recipe.
    void setJog(JogSpeed speed, double step, int place);
    void endHold();
    [[nodiscard]] const ModuleContext& context() const { return m_context; }
    void remove();

signals:
    /// The axis is to be homed one place earlier.
    void earlierWanted(nmc::ModuleIndex module);

private:
    void refresh();
    void nameControls(const QString& who);
    void step(bool reverse);
    [[nodiscard]] std::optional<bus::HoldToMove> wantedHold(bool reverse) const;
    [[nodiscard]] std::optional<Intent> wantedStep(bool reverse) const;
    [[nodiscard]] QString whyNotHeld(bool reverse) const;
    [[nodiscard]] QString whyNotStepped(bool reverse) const;

    ModuleContext m_context;
    JogSpeed m_speed = JogSpeed::Slow;
    double m_step = 1.0;
    int m_place = 0;
    QString m_named;  ///< axis and place that the controls were named by last
    QLabel* m_name;
    QLabel* m_state;
    QLabel* m_position;
    HoldButton* m_holdReverse;
    HoldButton* m_holdForward;
    Command* m_stepReverse;
    Command* m_stepForward;
    Command* m_earlier;
};

}  // namespace nmc
