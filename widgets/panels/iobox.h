// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>

#include "widgets/panels/modulecontext.h"

class QCheckBox;
class QComboBox;
class QLabel;

namespace nmc {

class FormGrid;
class GlyphLabel;

/// Inputs and outputs of a PIC-SERVO: the limit pins, which may be inputs or outputs (DS-V 5.2 I/O Control),
/// the index, the A/D value in the user's scale, motor power, and AMP_EN. One command sets both pins, so if
/// another host may have set them, it is sent only once the user has chosen both.
class IoBox : public QWidget {
    Q_OBJECT

public:
    IoBox(ModuleContext& context, QWidget* parent);

private:
    struct Pin {
        QComboBox* use = nullptr;
        GlyphLabel* glyph = nullptr;
        QLabel* value = nullptr;
    };
    struct Indicator {
        GlyphLabel* glyph = nullptr;
        QLabel* value = nullptr;
    };

    Pin addPin(FormGrid* grid, int number);
    Indicator addInput(FormGrid* grid, const QString& label, const QString& objectName,
                       const QString& meaning);
    static void show(const Indicator& input, std::optional<bool> set, const QString& on, const QString& off);
    void control();
    void showModule();
    void showUses(bool known);
    void refresh();

    ModuleContext& m_context;
    std::array<Pin, 2> m_pins;
    Indicator m_index;
    Indicator m_power;
    QLabel* m_analog = nullptr;
    QCheckBox* m_amplifier = nullptr;
    QCheckBox* m_fastPath = nullptr;  ///< CMC only
    QLabel* m_remark = nullptr;
    QString m_usualRemark;
    bool m_choosing = false;  ///< what was unknown is being chosen
};

}  // namespace nmc
