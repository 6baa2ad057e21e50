// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>
#include <optional>

#include "model/intent/intent.h"
#include "widgets/common/quantityfield.h"
#include "widgets/panels/panelview.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace nmc {

class HoldFirstButton;
class NumberField;
class Requests;

/// Form of a test of the loop: its settings, the buttons that start and end it, and its progress, its
/// failure, or why it is not possible now. GUI thread.
class TestForm : public QWidget {
    Q_OBJECT

public:
    struct Words {
        QString objectName;  ///< prefix of the object names of its buttons
        QString start;
        QString meaning;
    };
    TestForm(ProcedureKind kind, const Words& words, Requests& requests, QWidget* parent);

    /// Adds a row. `name`: as in NumberField::setWords().
    NumberField* addNumber(const QString& objectName, const QString& label, const QString& name,
                           const QString& unit, int decimals);
    QuantityField* addQuantity(QuantityField::Kind kind, const QString& objectName, const QString& label,
                               const QString& name);
    void addRow(const QString& label, QWidget* field, QWidget* unit);
    /// `wanted` returns the intent for the values in the fields; it is called only while none of them has a
    /// problem.
    void setWanted(std::function<Intent()> wanted) { m_wanted = std::move(wanted); }

    // These emit nothing.
    void showModule(const PanelView& view);
    void showNothing();

private:
    [[nodiscard]] bool running() const { return m_report && !m_report->over(); }
    void refresh();
    void start();
    [[nodiscard]] QString whyNotNow() const;
    /// Why the intent for the values in the fields is refused; empty if it is not, or if a field has a
    /// problem.
    [[nodiscard]] std::optional<Refusal> refusal() const;

    Requests& m_requests;
    ProcedureKind m_kind;
    QString m_meaning;
    std::function<Intent()> m_wanted;
    std::vector<NumberField*> m_fields;
    QGridLayout* m_grid = nullptr;
    QPushButton* m_start = nullptr;
    QPushButton* m_end = nullptr;
    HoldFirstButton* m_hold = nullptr;
    QLabel* m_state = nullptr;
    std::optional<ModuleState> m_module;
    std::optional<ProcedureReport> m_report;  ///< the last one of a test of this kind on that module
    bool m_connected = false;
};

}  // namespace nmc
