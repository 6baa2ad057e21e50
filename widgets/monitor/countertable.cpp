// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/countertable.h"

#include <QHeaderView>
#include <utility>

#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/texts.h"

namespace nmc {

using namespace Qt::StringLiterals;
using bus::LinkStatistics;

namespace {

enum { ValueColumn, MeaningColumn, kColumns };

QString count(std::uint64_t value) {
    return texts::grouped(static_cast<qint64>(value));
}

QString milliseconds(Duration time) {
    return Common::tr("%1 ms").arg(texts::readout(1e3 * toSeconds(time), 3));
}

}  // namespace

CounterTable::CounterTable(QWidget* parent) : QTableWidget(0, kColumns, parent) {
    look::name(this, u"counterTable"_s, tr("Counters of the link"));
    setHorizontalHeaderLabels({tr("Count"), tr("Since the chain was found")});
    horizontalHeader()->setStretchLastSection(true);
    horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    horizontalHeader()->setHighlightSections(false);
    verticalHeader()->hide();
    verticalHeader()->setMinimumSectionSize(1);
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + look::gridUnit(this) / 3);
    setColumnWidth(ValueColumn, fontMetrics().averageCharWidth() * 14);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setTabKeyNavigation(false);
    setShowGrid(false);
    setFrameShape(QFrame::NoFrame);

    addCount(tr("sent: commands that asked for an answer"), &LinkStatistics::exchanges);
    addCount(tr("accepted: answers that passed all checks"), &LinkStatistics::answered);
    addRow(tr("mean round trip, from sending a command to its complete answer"), [](const LinkStatistics& s) {
        return s.answered > 0 ? milliseconds(s.roundTripSum / static_cast<Duration::rep>(s.answered))
                              : u"–"_s;
    });
    addRow(tr("longest round trip"),
           [](const LinkStatistics& s) { return s.answered > 0 ? milliseconds(s.roundTripMax) : u"–"_s; });
    addCount(tr("retried: commands that were sent again"), &LinkStatistics::retries);
    addCount(tr("timeouts: no answer, or too few bytes"), &LinkStatistics::timeouts);
    addCount(tr("refused by the module: the command reached it with a wrong checksum"),
             &LinkStatistics::refused);
    addCount(tr("wrong checksums: the answer was corrupted in transit"), &LinkStatistics::badChecksum);
    addCount(tr("surplus bytes: received without a request"), &LinkStatistics::surplusBytes);
    addCount(tr("of these, stale: late answers, discarded"), &LinkStatistics::staleBytes);
    addCount(tr("resyncs: link checked again after errors"), &LinkStatistics::resyncs);
    addCount(tr("rejected by a rule: checksum right, but answer implausible"), &LinkStatistics::rejected);
    for (std::size_t i = 0; i < bus::kRejections; ++i)
        addRow(tr("  of these: %1").arg(texts::rejection(static_cast<bus::Rejection>(i))),
               [i](const LinkStatistics& s) { return count(s.rejections.at(i)); });
    showStatistics({});
}

void CounterTable::addCount(const QString& meaning, std::uint64_t LinkStatistics::*counter) {
    addRow(meaning, [counter](const LinkStatistics& s) { return count(s.*counter); });
}

void CounterTable::addRow(const QString& meaning, Value value) {
    const int row = rowCount();
    insertRow(row);
    m_values.push_back(std::move(value));
    auto* cell = new QTableWidgetItem;
    cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    cell->setFont(look::tabular(font()));
    auto* text = new QTableWidgetItem(meaning);
    text->setToolTip(meaning.trimmed());
    setItem(row, ValueColumn, cell);
    setItem(row, MeaningColumn, text);
}

void CounterTable::showStatistics(const LinkStatistics& statistics) {
    int row = 0;
    for (const Value& value : m_values) {
        QTableWidgetItem* cell = item(row++, ValueColumn);
        if (const QString text = value(statistics); cell->text() != text)
            cell->setText(text);
    }
}

}  // namespace nmc
