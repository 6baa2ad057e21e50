// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "widgets/panels/modulecontext.h"

class QCheckBox;
class QLabel;
class QLineEdit;

namespace nmc {

class Command;
class FormGrid;
class GlyphLabel;

/// Outputs and inputs of one PIC-STEP. The chip sets all five outputs at once and does not report them: while
/// they are unknown, all five are selected first and then sent; after that, each acts at once.
class StepperIoBox : public QWidget {
    Q_OBJECT

public:
    StepperIoBox(ModuleContext& context, QWidget* parent);

private:
    static constexpr std::size_t kOutputs = 5;
    static constexpr std::size_t kInputs = 6;
    struct Output {
        QCheckBox* box = nullptr;
        QLineEdit* name = nullptr;
        QLabel* state = nullptr;
    };
    struct Input {
        GlyphLabel* glyph = nullptr;
        QLabel* state = nullptr;
        QLabel* effect = nullptr;
        QLineEdit* name = nullptr;  ///< IN1 and IN2 only
    };

    void buildOutputs(FormGrid* grid);
    void buildInputs(FormGrid* grid);
    using Name = std::string& (*)(AxisSettings& axis, std::size_t number);
    QLineEdit* newName(const QString& objectName, const QString& accessibleName, Name name,
                       std::size_t number);
    void choose(std::size_t output, bool on);
    void showNames();
    void sendAll();
    [[nodiscard]] std::optional<std::uint8_t> staged() const;
    [[nodiscard]] QString effectOf(std::size_t input, bool active) const;
    void showModule();
    void refresh();

    ModuleContext& m_context;
    std::array<Output, kOutputs> m_outputs;
    std::array<Input, kInputs> m_inputs;
    Command* m_send;
    QLabel* m_hint;
    QLabel* m_analog;
    /// Levels selected while the outputs are unknown.
    std::array<std::optional<bool>, kOutputs> m_staged;
};

}  // namespace nmc
