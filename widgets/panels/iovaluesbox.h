// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>

#include "widgets/panels/modulecontext.h"

class QCheckBox;
class QGridLayout;
class QLabel;
class QLineEdit;

namespace nmc {

class NumberField;

/// The three A/D inputs of one PIC-I/O, each with its own scale, and its two PWM outputs.
class IoValuesBox : public QWidget {
    Q_OBJECT

public:
    IoValuesBox(ModuleContext& context, QWidget* parent);

private:
    struct Analog {
        QLineEdit* name = nullptr;
        QLabel* value = nullptr;
        NumberField* perCount = nullptr;
        NumberField* atZero = nullptr;
        QLineEdit* unit = nullptr;
    };
    struct Pwm {
        QLineEdit* name = nullptr;
        NumberField* field = nullptr;
        QLabel* state = nullptr;
        QCheckBox* offAtStop = nullptr;
    };

    void buildAnalog(QGridLayout& grid, int row);
    void buildPwm(QGridLayout& grid, int row);
    QLineEdit* newText(const QString& objectName, const QString& accessibleName);
    NumberField* newNumber(const QString& objectName, const QString& accessibleName);
    void editAnalog(std::size_t number, const std::function<void(AnalogInput&)>& change);
    void editPwm(std::size_t number, const std::function<void(OutputSettings&)>& change);
    void sendPwm(unsigned output);
    void showModule();
    void refresh();

    ModuleContext& m_context;
    std::array<Analog, 3> m_analog;
    std::array<Pwm, 2> m_pwm;
};

}  // namespace nmc
