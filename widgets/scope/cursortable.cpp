// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/cursortable.h"

#include <QHeaderView>
#include <cmath>

#include "widgets/common/look.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

CursorTable::CursorTable(QWidget* parent) : QTableWidget(0, 4, parent) {
    look::name(this, u"scopeCursorTable"_s, tr("What the cursors read"));
    setHorizontalHeaderLabels({tr("Signal"), tr("Cursor 1"), tr("Cursor 2"), tr("Difference")});
    verticalHeader()->hide();
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionMode(QAbstractItemView::NoSelection);
    setFocusPolicy(Qt::NoFocus);
    setFont(look::tabular(look::scaled(font(), 0.9)));
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() * 3 / 2);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
}

QSize CursorTable::sizeHint() const {
    int width = 2 * frameWidth();
    for (int column = 0; column < columnCount(); ++column)
        width += columnWidth(column);
    return {width, fontMetrics().height() * 6};
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

void CursorTable::showReadings(const ScopeStrips& strips, const History& history) {
    if (!strips.cursors() || !history.zero())
        return setRowCount(0);
    const CursorTimes times = *strips.cursors();
    const double between = times[1] - times[0];
    int row = 0;
    const auto add = [&](const QString& name, const QString& first, const QString& second,
                         const QString& difference) {
        if (row == rowCount())
            setRowCount(row + 1);
        setCell(row, 0, name);
        setCell(row, 1, first);
        setCell(row, 2, second);
        setCell(row, 3, difference);
        ++row;
    };
    const QString frequency =
        between == 0.0 ? QString() : tr(" (%1 Hz)").arg(texts::readout(std::abs(1 / between)));
    add(tr("time"), tr("%1 s").arg(QLocale().toString(times[0], 'f', 4)),
        tr("%1 s").arg(QLocale().toString(times[1], 'f', 4)), texts::stretch(between) + frequency);
    for (const ScopePlot* plot : strips.shownPlots()) {
        for (const ScopePlot::Trace& trace : plot->traces()) {
            const ModuleHistory* samples = history.module(trace.module);
            if (samples == nullptr)
                continue;
            const ScopeModule& module = strips.modules()[trace.module.value()];
            const auto read = [&](double seconds) {
                const auto value = samples->valueAt(*history.zero() + fromSeconds(seconds), trace.signal);
                return value ? std::optional(trace.scale(*value)) : std::nullopt;
            };
            const auto text = [&](std::optional<double> value) {
                return value ? texts::numberAt(*value, texts::signalStep(trace.signal, module)) : u"–"_s;
            };
            const auto first = read(times[0]);
            const auto second = read(times[1]);
            add(texts::signalName(trace.signal) + (trace.tag.isEmpty() ? QString() : u' ' + trace.tag),
                text(first), text(second),
                text(first && second ? std::optional(*second - *first) : std::nullopt));
        }
    }
    setRowCount(row);
    updateGeometry();
}

}  // namespace nmc
