// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <functional>

#include "widgets/panels/modulecontext.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;

namespace nmc {

class Command;
class GlyphLabel;

/// The twelve pins of one PIC-I/O: direction, level, name, and, for outputs, the control that switches them
/// and how careful the panel is with that. The chip reports the level of a pin but not its direction, so
/// while directions are unknown, all pins have to be made inputs first.
class PinBox : public QWidget {
    Q_OBJECT

public:
    PinBox(ModuleContext& context, QWidget* parent);

    /// The question whether this output may be switched to that level; empty if it is an input, or has that
    /// level already.
    [[nodiscard]] static QString question(const ModuleContext& context, unsigned pin, bool high);
    /// Asks before outputs are switched: what `text` returns, for as long as it is not empty.
    static void askFirst(QWidget* owner, const std::function<QString()>& text, const QString& verb,
                         const std::function<void()>& go);

private:
    enum Column { Label, Direction, Level, High, Name, Asks, OffAtStop };
    enum Choice { Input, Output, Unknown };
    struct Pin {
        QComboBox* direction = nullptr;
        GlyphLabel* glyph = nullptr;
        QLabel* level = nullptr;
        QCheckBox* high = nullptr;
        QLineEdit* name = nullptr;
        QCheckBox* asks = nullptr;
        QCheckBox* offAtStop = nullptr;
    };

    void build(QGridLayout& grid);
    void buildPin(QGridLayout& grid, unsigned number);
    void setDirection(unsigned pin, int choice);
    void setOutput(unsigned pin, bool high);
    /// Passes on the request, which switches this pin to that level, or asks first.
    void switchOutput(unsigned pin, bool high, const std::function<Intent()>& request);
    void showModule();
    void showSettings();
    void refresh();
    void refreshPin(unsigned number);

    ModuleContext& m_context;
    std::array<Pin, io::kPins> m_pins;
    Command* m_allInputs;
    QLabel* m_hint;
};

}  // namespace nmc
