// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QStringList>
#include <QTimer>
#include <QWidget>
#include <optional>

#include "base/strong.h"

class QComboBox;
class QJsonObject;
class QLabel;
class QStackedWidget;

namespace nmc {

class BenchTruth;
class ControlLineBox;
class ModuleBench;

/// Content of the Simulator dock: switches, power, cables and loads of one simulated module, its true state,
/// and a line for everything else. Queries what it shows while it is visible.
class SimulatorBench : public QWidget {
    Q_OBJECT

public:
    explicit SimulatorBench(QWidget* parent);

    /// For another simulator: discards everything that was known of the previous one or awaited from it.
    void begin();
    /// Offers at least `count` modules; there may be more that the panel has not found.
    void offerModules(int count);
    /// Follows the selection in the panel when it changes. The module selected in the bench may differ, and
    /// may be one that the panel cannot find.
    void showSelected(std::optional<ModuleIndex> module);
    /// Shows the answer to a line of lineEntered().
    void showAnswer(const QString& line, const QByteArray& json);

signals:
    void lineEntered(const QString& line);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void buildContent();
    void chooseModule();
    void setModules(int count);
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
    std::optional<ModuleIndex> m_followed;
    QStringList m_typed;      ///< lines typed by the user that wait for their answer
    QString m_polled;         ///< the state line that waits for its answer; empty: none
    bool m_outdated = false;  ///< something was changed since m_polled was sent
    int m_ticks = 0;
    int m_waited = 0;  ///< ticks since m_polled was sent
};

}  // namespace nmc
