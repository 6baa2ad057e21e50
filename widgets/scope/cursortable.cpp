// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/cursortable.h"

#include <QHeaderView>
#include <QScrollBar>
#include <algorithm>
#include <cmath>

#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr int kMostRows = 7;  ///< without scrolling
const QString kNothing = u"–"_s;
}  // namespace

CursorTable::CursorTable(QWidget* parent) : QTableWidget(0, 9, parent) {
    look::name(this, u"scopeCursorTable"_s, Common::tr("Cursor readings"));
    setHorizontalHeaderLabels({Common::tr("Signal"), Common::tr("Cursor 1"), Common::tr("Cursor 2"),
                               Common::tr("Difference"), tr("Mean"), tr("RMS"), tr("Peak to peak"),
                               tr("Slope, per s"), tr("Frequency")});
    verticalHeader()->hide();
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionMode(QAbstractItemView::NoSelection);
    setFocusPolicy(Qt::NoFocus);
    setFont(look::tabular(look::scaled(font(), 0.9)));
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() * 3 / 2);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
}

QSize CursorTable::sizeHint() const {
    int width = 2 * frameWidth();
    for (int column = 0; column < columnCount(); ++column)
        width += columnWidth(column);
    const int rows = std::clamp(rowCount(), 1, kMostRows) * verticalHeader()->defaultSectionSize();
    const int bar = width > this->width() ? horizontalScrollBar()->sizeHint().height() : 0;
    return {width, horizontalHeader()->sizeHint().height() + rows + 2 * frameWidth() + bar};
}

void CursorTable::setCell(int row, int column, const QString& text) {
    QTableWidgetItem* cell = item(row, column);
    if (cell == nullptr) {
        cell = new QTableWidgetItem;
        if (column > 0)
            cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        setItem(row, column, cell);
    }
    if (cell->text() != text)
        cell->setText(text);
}

const std::optional<StretchFigures>& CursorTable::figures(const ScopeStretch& stretch) {
    auto kept = std::ranges::find_if(m_kept, [&](const Kept& one) { return one.stretch.of == stretch.of; });
    if (kept == m_kept.end())
        kept = m_kept.insert(kept, Kept{{stretch.of}});
    if (kept->stretch == stretch)
        return kept->figures;
    if (m_made) {
        m_upToDate = false;
        return kept->figures;
    }
    m_made = true;
    kept->stretch = stretch;
    kept->figures.reset();
    if (stretch.read(m_points))
        kept->figures = figuresOf(m_points, std::abs(stretch.scale.factor));
    return kept->figures;
}

QString CursorTable::between(const CursorTimes& times) {
    const double between = times[1] - times[0];
    return texts::stretch(between) +
           (between == 0.0 ? QString() : tr(" (%1 Hz)").arg(texts::readout(std::abs(1 / between))));
}

bool CursorTable::showReadings(const ScopeStrips& strips, const History& history) {
    if (!strips.cursors() || !history.zero()) {
        setRowCount(0);
        m_kept.clear();
        return true;
    }
    m_made = false;
    m_upToDate = true;
    const TimePoint zero = *history.zero();
    const CursorTimes times = *strips.cursors();
    int row = 0;
    const auto add = [&](const QStringList& cells) {
        if (row == rowCount())
            setRowCount(row + 1);
        for (int column = 0; column < columnCount(); ++column)
            setCell(row, column, cells.value(column));
        ++row;
    };
    constexpr double kTimeStep = 1e-4;
    add({Common::tr("time"), tr("%1 s").arg(texts::numberAt(times[0], kTimeStep)),
         tr("%1 s").arg(texts::numberAt(times[1], kTimeStep)), between(times)});
    for (const ScopePlot* plot : strips.shownPlots()) {
        for (const ScopePlot::Trace& trace : plot->traces()) {
            const auto source = strips.derived().source(history, {trace.module, trace.signal});
            if (source.samples == nullptr)
                continue;
            const ScopeModule& module = strips.modules()[trace.module.value()];
            const double step = texts::signalStep(trace.signal, module);
            const auto read = [&](double seconds) {
                const auto value = source.samples->valueAt(zero + fromSeconds(seconds), source.signal);
                return value ? std::optional(trace.scale(*value)) : std::nullopt;
            };
            const auto first = read(times[0]);
            const auto second = read(times[1]);
            QStringList cells{texts::signalName(trace.signal, module) +
                                  (trace.tag.isEmpty() ? QString() : u' ' + trace.tag),
                              first ? texts::numberAt(*first, step) : kNothing,
                              second ? texts::numberAt(*second, step) : kNothing,
                              first && second ? texts::numberAt(*second - *first, step) : kNothing};
            const auto& made = figures(stretchOf(trace, times, source, zero));
            // An average is more accurate than a single value.
            cells << (made ? texts::numberAt(made->mean, step / 10) : kNothing)
                  << (made ? texts::numberAt(made->rms, step / 10) : kNothing)
                  << (made ? texts::numberAt(made->peakToPeak, step) : kNothing)
                  << (made && made->slope ? texts::readout(*made->slope) : kNothing)
                  << (made && made->hertz ? Common::tr("%1 Hz").arg(texts::readout(*made->hertz, 3))
                                          : kNothing);
            add(cells);
        }
    }
    setRowCount(row);
    updateGeometry();
    return m_upToDate;
}

}  // namespace nmc
