// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QDockWidget>
#include <optional>

#include "model/module/linkstate.h"

namespace nmc {

class SimulatorBench;

/// The bench that a real chain would stand on: switches, power, cables, loads, set by mouse while it runs.
/// It speaks the control lines of nmcsim and knows nothing but their answers. Only there while the window is
/// attached to the built-in simulator, and built when that is so for the first time; whether the user wants
/// it open then is remembered by the owner.
class SimulatorDock : public QDockWidget {
    Q_OBJECT

public:
    explicit SimulatorDock(QWidget* parent = nullptr);

    /// Open it whenever a simulator is there. Emits nothing.
    void setWanted(bool wanted);
    void showLink(const LinkState& link);
    // As the bench's.
    void showSelected(std::optional<ModuleIndex> module);
    void showAnswer(const QString& line, const QByteArray& json);

    /// What it had when it was last seen, or what its content wants.
    [[nodiscard]] int wantedHeight() const;

signals:
    void shown();
    void lineEntered(const QString& line);
    /// The user closed it, or opened it again.
    void wantedChanged(bool wanted);

protected:
    void closeEvent(QCloseEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void build();
    void appear();
    void want(bool wanted);

    SimulatorBench* m_bench = nullptr;
    bool m_attached = false;
    int m_height = 0;  ///< when it was last seen; 0: not yet
    bool m_wanted = true;
};

}  // namespace nmc
