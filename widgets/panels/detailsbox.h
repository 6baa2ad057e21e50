// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <functional>
#include <string_view>
#include <vector>

#include "widgets/panels/modulecontext.h"

class QLabel;

namespace nmc {

class Command;
class FlowLayout;
class FormGrid;
class GlyphLabel;

/// Two bytes of a servo's or a stepper's status bit by bit under the data sheet's names, the other status
/// items, the raw bytes, and two buttons.
class DetailsBox : public QWidget {
    Q_OBJECT

public:
    /// The object names of a stepper's controls begin with "stepper".
    DetailsBox(ModuleContext& context, QWidget* parent);

private:
    struct Bit {
        GlyphLabel* glyph = nullptr;
        QLabel* value = nullptr;
    };
    using Bits = std::array<Bit, 8>;
    /// The text for the value of a status; empty if it is not in it.
    using Reading = std::function<QString(const StatusReport&)>;
    struct Value {
        QLabel* label;
        Reading reading;
    };

    void addServo();
    void addStepper();
    /// Bits without a name are left out. `meanings`: for the tool tips.
    Bits addBits(const QString& title, const std::array<std::string_view, 8>& names,
                 const std::array<QString, 8>& meanings);
    QLabel* addValue(const QString& label, const QString& objectName, const Reading& reading);
    void addAnalog(const QString& label);
    /// Adds the home register and the raw bytes. `aux`: the second of these, ", inputs %1".
    void addEnd(const QString& aux);
    void refresh();
    static void showBits(const Bits& bits, std::optional<std::uint8_t> byte);
    [[nodiscard]] QString timer(std::uint16_t count) const;

    ModuleContext& m_context;
    FormGrid* m_grid;
    FlowLayout* m_bytes;
    Bits m_status;
    Bits m_aux;  ///< or a stepper's inputs
    std::vector<Value> m_values;
    Command* m_first = nullptr;  ///< Clear sticky bits; a stepper's Zero here
    Command* m_saveHome = nullptr;
};

}  // namespace nmc
