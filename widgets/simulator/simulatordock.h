// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QDockWidget>
#include <optional>

#include "model/module/linkstate.h"

namespace nmc {

class SimulatorBench;

/// The bench of a simulated chain: switches, power, cables and loads, set with the mouse while it runs. It
/// uses the control lines of nmcsim and knows nothing but their answers. Available only while the window is
/// connected to the built-in simulator, and built when it first is; the owner remembers whether the user
/// wants it open.
class SimulatorDock : public QDockWidget {
    Q_OBJECT

public:
    explicit SimulatorDock(QWidget* parent = nullptr);

    /// Sets whether the dock is open while there is a simulator. Emits nothing.
    void setWanted(bool wanted);
    void showLink(const LinkState& link);
    // As in SimulatorBench.
    void showSelected(std::optional<ModuleIndex> module);
    void showAnswer(const QString& line, const QByteArray& json);

signals:
    /// A control line for the built-in simulator; only while attached to it.
    void lineEntered(const QString& line);
    /// The user closed it, or opened it again.
    void wantedChanged(bool wanted);

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void build();
    void appear();
    void want(bool wanted);

    SimulatorBench* m_bench = nullptr;
    std::optional<std::uint32_t> m_attached;  ///< number of the connection
    bool m_wanted = true;
};

}  // namespace nmc
