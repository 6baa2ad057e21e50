// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QList>
#include <QTabWidget>

#include "protocol/moduletype.h"
#include "widgets/simulator/benchrow.h"

class QAbstractButton;
class QGridLayout;
class QLabel;

namespace nmc {

/// What can be done by hand to one simulated module: its switches or pins, its power and its cable on one
/// page, and for a motor, its load and travel on the other. Shows the simulator's `state`, and requests
/// changes by control lines.
class ModuleBench : public QTabWidget {
    Q_OBJECT

public:
    /// For a servo, stepper or PIC-I/O; the object names of the controls differ.
    explicit ModuleBench(ModuleType type, QWidget* parent = nullptr);

    /// Selects the module to change, counting from 1; discards what was typed for another one.
    void setModule(int number);
    /// Shows the answer to `state N`. Emits nothing.
    void showState(const QJsonObject& state);

signals:
    void lineEntered(const QString& line);

private:
    struct Switch {
        QString name;
        QAbstractButton* box = nullptr;
        QString meaning;
    };

    void buildSwitches();
    void buildPins();
    void showPins(const QJsonObject& state);
    void buildCable(QGridLayout& grid);
    void buildMechanics();
    QAbstractButton* addSwitch(QGridLayout& grid, const QString& name, const QString& text,
                               const QString& meaning);
    QAbstractButton* addButton(QGridLayout& grid, int column, const QString& objectName, const QString& text,
                               const QString& meaning);
    void addRow(QGridLayout& grid, BenchQuantity quantity);
    void set(const QString& name, const QString& value);
    void say(const QString& verb);

    ModuleType m_type;
    QString m_prefix;  ///< of the object names
    int m_number = 1;
    QList<Switch> m_switches;
    QList<BenchRow*> m_rows;
    QList<QAbstractButton*> m_pins;  ///< IO1 first
    QLabel* m_pwm = nullptr;
    QLabel* m_count = nullptr;
    QAbstractButton* m_limitsAutomatic = nullptr;
    QAbstractButton* m_addressBroken = nullptr;
};

}  // namespace nmc
