// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>
#include <optional>

#include "widgets/panels/panelview.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace nmc {

class HoldFirstButton;
class NumberField;
class QuantityField;

/// How a test of the loop is made, the buttons that begin and end it, and why it is not possible now, how it
/// goes, or how it ended. GUI thread.
class TestForm : public QWidget {
    Q_OBJECT

public:
    struct Words {
        QString objectName;  ///< those of its buttons begin with it
        QString start;
        QString meaning;
    };
    TestForm(ProcedureKind kind, const Words& words, QWidget* parent);

    /// A row more. `name`: as in NumberField::setWords().
    NumberField* addNumber(const QString& objectName, const QString& label, const QString& name,
                           const QString& unit, int decimals);
    QuantityField* addDistance(const QString& objectName, const QString& label, const QString& name);
    void addRow(const QString& label, QWidget* field, QWidget* unit);
    /// What the fields say; asked only while none of them has a problem.
    void setWanted(std::function<Intent()> wanted) { m_wanted = std::move(wanted); }

    // Emit nothing.
    void showModule(const PanelView& view);
    void showNothing();

    [[nodiscard]] bool running() const { return m_report && !m_report->over(); }
    /// Of this kind, the last of the module that is shown.
    [[nodiscard]] const std::optional<ProcedureReport>& report() const { return m_report; }

signals:
    void asked(nmc::ModuleIndex module, const nmc::Intent& intent);

private:
    void refresh();
    void start();
    [[nodiscard]] QString whyNotNow() const;
    /// Of what the fields say, while they have no problem.
    [[nodiscard]] std::optional<Refusal> refusal() const;

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
    std::optional<ProcedureReport> m_report;
    bool m_connected = false;
};

}  // namespace nmc
