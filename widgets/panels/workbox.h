// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <QStringList>

#include "widgets/panels/modulecontext.h"

class QComboBox;
class QLabel;
class QLineEdit;

namespace nmc {

class Command;
class FormGrid;
class QuantityField;

/// The work offsets of an axis: which one its positions count from, and another one by what the present
/// position is to be called. Sends nothing, and leaves the chip's counter and home alone. Offsets that count
/// from home are kept with the axis.
class WorkBox : public QGroupBox {
    Q_OBJECT

public:
    WorkBox(ModuleContext& context, QWidget* parent);

private:
    void buildChoice(FormGrid* grid);
    void buildCall(FormGrid* grid);
    /// With an empty name, the counter.
    void choose(const std::string& name);
    void remove();
    void call();
    void showModule();
    void showChoice();
    void refresh();
    [[nodiscard]] const WorkOffset* kept(const std::string& name) const;
    /// The offset that is to be made; empty: it cannot be.
    [[nodiscard]] std::optional<WorkOffset> called() const;
    /// Why the offsets cannot be changed now: not connected, or operator mode.
    [[nodiscard]] QString whyLocked() const;
    /// Why none can be made, as a sentence.
    [[nodiscard]] QString whyNotCalled() const;

    ModuleContext& m_context;
    QStringList m_names;  ///< as last shown to be chosen from
    QComboBox* m_choice = nullptr;
    Command* m_clear = nullptr;
    Command* m_delete = nullptr;
    QuantityField* m_called = nullptr;
    QLineEdit* m_name = nullptr;
    Command* m_call = nullptr;
    QLabel* m_hint = nullptr;
};

}  // namespace nmc
