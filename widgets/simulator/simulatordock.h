// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QDockWidget>
#include <QStringList>
#include <QTimer>
#include <optional>

#include "model/module/linkstate.h"

class QComboBox;
class QJsonObject;
class QLabel;
class QStackedWidget;

namespace nmc {

class BenchTruth;
class ControlLineBox;
class ModuleBench;

/// The bench that a real chain would stand on: switches, power, cables, loads, set by mouse while it runs.
/// It speaks the control lines of nmcsim and knows nothing but their answers. Only there while the window is
/// attached to the built-in simulator; whether the user wants it open then is remembered by the owner.
class SimulatorDock : public QDockWidget {
    Q_OBJECT

public:
    explicit SimulatorDock(QWidget* parent = nullptr);

    /// Open it whenever a simulator is there. Emits nothing.
    void setWanted(bool wanted);
    void showLink(const LinkState& link);
    /// Follows the selection where it changes; the dock's own choice may differ, and reaches modules that the
    /// panel cannot find.
    void showSelected(std::optional<ModuleIndex> module);
    /// The answer to a lineEntered().
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
    void buildContent();
    void appear();
    void want(bool wanted);
    void chooseModule();
    void offerModules(int count);
    void change(const QString& line);
    void tick();
    void poll();
    void showState(const QJsonObject& state);
    [[nodiscard]] QString stateLine() const;

    QComboBox* m_module;
    QLabel* m_type;
    QStackedWidget* m_benches;
    ModuleBench* m_servo;
    ModuleBench* m_step;
    ModuleBench* m_io;
    BenchTruth* m_truth;
    ControlLineBox* m_line;
    QTimer m_timer;
    bool m_attached = false;
    int m_height = 0;  ///< when it was last seen; 0: not yet
    bool m_wanted = true;
    std::optional<ModuleIndex> m_followed;
    QStringList m_typed;      ///< lines of the user's that wait for their answer
    QString m_polled;         ///< the state line that waits for its answer; empty: none
    bool m_outdated = false;  ///< something was changed since m_polled was asked
    int m_ticks = 0;
    int m_waited = 0;  ///< ticks since m_polled was asked
};

}  // namespace nmc
