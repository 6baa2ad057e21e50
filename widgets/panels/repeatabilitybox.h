// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>

#include "widgets/panels/modulecontext.h"

class QComboBox;
class QLabel;

namespace nmc {

class Command;
class NumberField;
class QuantityField;

/// Approaches a switch or the index from both sides (model/procedure/repeatabilityrun.h) with the search
/// settings of the axis, shows how well the captures repeat, and offers the backlash as that of the axis.
class RepeatabilityBox : public QGroupBox {
    Q_OBJECT

public:
    RepeatabilityBox(ModuleContext& context, QWidget* parent);

private:
    void buildFields();
    void use();
    void refresh();
    [[nodiscard]] bool running() const;
    [[nodiscard]] intent::MeasureRepeatability wanted() const;
    [[nodiscard]] QString whyNotNow() const;
    [[nodiscard]] QString whyNotUsed() const;
    /// What was measured: the backlash of the axis in counts, rounded up.
    [[nodiscard]] double offered() const;
    /// The state of the measurement, as a shape followed by words.
    [[nodiscard]] QString state() const;
    /// What has been captured so far, in lines.
    [[nodiscard]] QStringList found() const;
    /// "0.3 counts", "0.0015 mm (0.3 counts)"
    [[nodiscard]] QString amount(double counts) const;

    ModuleContext& m_context;
    QComboBox* m_input = nullptr;
    QuantityField* m_velocity = nullptr;
    NumberField* m_times = nullptr;
    Command* m_measure;
    Command* m_end;
    Command* m_use;
    QLabel* m_result;
    std::optional<ProcedureReport> m_report;  ///< of this connection, as shown
    std::optional<Repeatability> m_found;     ///< in that report
};

}  // namespace nmc
