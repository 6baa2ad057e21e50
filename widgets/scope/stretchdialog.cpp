// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/stretchdialog.h"

#include <algorithm>
#include <utility>

#include "widgets/common/look.h"
#include "widgets/common/words.h"
#include "widgets/scope/scopestrips.h"

namespace nmc {

namespace {

/// Frames between two updates while samples arrive or a cursor is dragged: one takes up to two frames.
constexpr int kPause = 12;

bool sameSignals(const std::vector<ScopeStretch>& a, const std::vector<ScopeStretch>& b) {
    return std::ranges::equal(a, b, {}, &ScopeStretch::of, &ScopeStretch::of);
}

}  // namespace

StretchDialog::StretchDialog(const QString& objectName, const QString& title, QWidget* parent)
    : QDialog(parent) {
    setWindowTitle(title);
    look::name(this, objectName, title);
}

TraceBox* StretchDialog::newBox(const QString& objectName, const QString& accessible, int first) {
    auto* box = new TraceBox(objectName, accessible, first, this);
    connect(box, &QComboBox::activated, this, &StretchDialog::frameWanted);
    m_boxes.push_back(box);
    return box;
}

bool StretchDialog::showStretch(const ScopeStrips& strips, const History& history) {
    if (!strips.cursors())
        return true;
    std::vector<ScopePlot::Trace> traces;
    for (const ScopePlot* plot : strips.shownPlots())
        traces.insert(traces.end(), plot->traces().begin(), plot->traces().end());
    std::vector<ScopeStretch> wanted;
    QStringList labels;
    for (TraceBox* box : m_boxes) {
        box->showTraces(traces);
        const ScopePlot::Trace* trace = box->trace();
        if (trace == nullptr || !history.zero())
            return showNothing();
        const auto source = strips.derived().source(history, {trace->module, readsFor(trace->signal)});
        if (source.samples == nullptr)
            return showNothing();
        wanted.push_back(stretchOf(*trace, *strips.cursors(), source, *history.zero()));
        labels << trace->label;
    }
    if (wanted == m_shown && labels == m_labels)
        return true;
    if (sameSignals(wanted, m_shown) && m_pause-- > 0)
        return false;
    m_pause = kPause;
    m_shown = std::move(wanted);
    m_labels = labels;
    m_samples.resize(m_boxes.size());
    for (std::size_t i = 0; i < m_boxes.size(); ++i) {
        Samples& samples = m_samples[i];
        samples.trace = *m_boxes[i]->trace();
        samples.unit =
            texts::signalUnit(samples.trace.signal, strips.modules()[samples.trace.module.value()]);
        samples.kept = m_shown[i].read(samples.points);
    }
    showSamples(m_samples);
    return true;
}

/// There are no samples of these signals, for example because another chain is being searched for.
bool StretchDialog::showNothing() {
    if (std::exchange(m_shown, {}).empty())
        return true;
    for (Samples& samples : m_samples) {
        samples.points.clear();
        samples.kept = true;
    }
    showSamples(m_samples);
    return true;
}

QString StretchDialog::whyNothing(const Samples& samples, std::size_t fewest, std::size_t most) {
    if (!samples.kept)
        return tr("These samples are no longer kept individually. Move the cursors to newer ones.");
    const std::size_t count = samples.points.size();
    if (count > most)
        return tr("%1 samples are between the cursors, and %2 are the most. Move the cursors closer together.")
            .arg(texts::grouped(static_cast<qint64>(count)), texts::grouped(static_cast<qint64>(most)));
    return count < fewest ? tr("Too few samples are between the cursors. Move them farther apart.")
                          : QString();
}

}  // namespace nmc
