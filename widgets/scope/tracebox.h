// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <vector>

#include "widgets/scope/scopeplot.h"

namespace nmc {

/// Chooses one of the traces that the scope shows. GUI thread.
class TraceBox : public QComboBox {
    Q_OBJECT

public:
    /// `first`: the trace that is chosen at first, if there are so many.
    TraceBox(const QString& objectName, const QString& accessible, int first, QWidget* parent);

    /// Offers these, and keeps the choice if it is among them.
    void showTraces(const std::vector<ScopePlot::Trace>& traces);
    /// Null if there is none.
    [[nodiscard]] const ScopePlot::Trace* trace() const;

private:
    std::vector<ScopePlot::Trace> m_traces;
    QStringList m_labels;
    int m_first;
};

}  // namespace nmc
