// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/tracebox.h"

#include <QSignalBlocker>
#include <algorithm>

#include "widgets/common/look.h"

namespace nmc {

TraceBox::TraceBox(const QString& objectName, const QString& accessible, int first, QWidget* parent)
    : QComboBox(parent), m_first(first) {
    look::name(this, objectName, accessible);
    setSizeAdjustPolicy(QComboBox::AdjustToContents);
}

void TraceBox::showTraces(const std::vector<ScopePlot::Trace>& traces) {
    QStringList labels;
    for (const ScopePlot::Trace& one : traces)
        labels << (one.tag.isEmpty() ? one.label : one.label + u' ' + one.tag);
    const auto chosen = trace() ? std::optional(*trace()) : std::nullopt;
    m_traces = traces;
    if (labels == m_labels)
        return;
    m_labels = labels;
    const auto again = std::ranges::find_if(traces, [&chosen](const ScopePlot::Trace& one) {
        return chosen && one.module == chosen->module && one.signal == chosen->signal;
    });
    const auto row =
        again != traces.end() ? again - traces.begin() : std::min<std::ptrdiff_t>(m_first, labels.size() - 1);
    const QSignalBlocker quiet(this);
    clear();
    addItems(labels);
    setCurrentIndex(static_cast<int>(row));
}

const ScopePlot::Trace* TraceBox::trace() const {
    const int row = currentIndex();
    return row >= 0 && row < static_cast<int>(m_traces.size()) ? &m_traces[static_cast<std::size_t>(row)]
                                                               : nullptr;
}

}  // namespace nmc
