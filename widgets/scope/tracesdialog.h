// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <array>
#include <vector>

#include "widgets/common/form.h"
#include "widgets/scope/tracedefinition.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace nmc {

/// Defines the user's own traces, one in each row. A row without a name defines none. GUI thread.
class TracesDialog : public QDialog {
    Q_OBJECT

public:
    TracesDialog(const TraceDefinitions& traces, const std::vector<ScopeModule>& modules, QWidget* parent);

signals:
    void tracesChosen(const nmc::TraceDefinitions& traces);

private:
    struct Part {
        QComboBox* signal;
        NumberField* factor;
    };
    struct Row {
        QLineEdit* name;
        Part first, second;
        NumberField* cutoff;
        QLineEdit* unit;
    };
    [[nodiscard]] Row newRow(std::size_t index, const QList<form::Option>& options);
    [[nodiscard]] Part newPart(const QString& objectName, const QString& accessible,
                               const QList<form::Option>& options);
    static void fill(const Row& row, const TraceDefinition& trace);
    /// Why it cannot be taken; empty if it can.
    [[nodiscard]] static QString problemOf(const Row& row);
    [[nodiscard]] static std::optional<TraceDefinition> traceOf(const Row& row);
    void refresh();

    std::array<Row, kCustomSignals> m_rows{};
    QLabel* m_problem;
    QPushButton* m_apply;
};

}  // namespace nmc
