// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/countertable.h"

#include <QHeaderView>

#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/texts.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

/// The rows before those of the rejection rules, in this order.
enum FirstRow {
    Sent,
    Accepted,
    RoundTripMean,
    RoundTripMax,
    Retried,
    TimeOuts,
    Refused,
    WrongSums,
    SurplusBytes,
    StaleBytes,
    Resyncs,
    Rejected,
    kFirstRows
};

enum { ValueColumn, MeaningColumn, kColumns };

QString count(std::uint64_t value) {
    return texts::grouped(static_cast<qint64>(value));
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

    addRow(u"sent"_s, tr("sent: commands that asked for an answer"));
    addRow(u"accepted"_s, tr("accepted: answers that passed all checks"));
    addRow(u"roundTripMean"_s, tr("mean round trip, from sending a command to its complete answer"));
    addRow(u"roundTripMax"_s, tr("longest round trip"));
    addRow(u"retried"_s, tr("retried: commands that were sent again"));
    addRow(u"timeOuts"_s, tr("timeouts: no answer, or too few bytes"));
    addRow(u"refused"_s, tr("refused by the module: the command reached it with a wrong checksum"));
    addRow(u"wrongSums"_s, tr("wrong checksums: the answer was corrupted in transit"));
    addRow(u"surplusBytes"_s, tr("surplus bytes: received without a request"));
    addRow(u"staleBytes"_s, tr("of these, stale: late answers, discarded"));
    addRow(u"resyncs"_s, tr("resyncs: link checked again after errors"));
    addRow(u"rejected"_s, tr("rejected by a rule: checksum right, but answer implausible"));
    for (std::size_t i = 0; i < bus::kRejections; ++i)
        addRow(u"rejection%1"_s.arg(i),
               tr("  of these: %1").arg(texts::rejection(static_cast<bus::Rejection>(i))));
    showStatistics({});
}

void CounterTable::addRow(const QString& key, const QString& meaning) {
    const int row = rowCount();
    insertRow(row);
    auto* value = new QTableWidgetItem;
    value->setData(Qt::UserRole, key);
    value->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    value->setFont(look::tabular(font()));
    auto* text = new QTableWidgetItem(meaning);
    text->setToolTip(meaning.trimmed());
    setItem(row, ValueColumn, value);
    setItem(row, MeaningColumn, text);
}

void CounterTable::setValue(int row, const QString& value) {
    if (QTableWidgetItem* cell = item(row, ValueColumn); cell->text() != value)
        cell->setText(value);
}

void CounterTable::showStatistics(const bus::LinkStatistics& statistics) {
    const auto milliseconds = [](Duration time) {
        return Common::tr("%1 ms").arg(texts::readout(1e3 * toSeconds(time), 3));
    };
    const bool answered = statistics.answered > 0;
    const Duration mean =
        answered ? statistics.roundTripSum / static_cast<Duration::rep>(statistics.answered) : Duration{};
    setValue(Sent, count(statistics.exchanges));
    setValue(Accepted, count(statistics.answered));
    setValue(RoundTripMean, answered ? milliseconds(mean) : u"–"_s);
    setValue(RoundTripMax, answered ? milliseconds(statistics.roundTripMax) : u"–"_s);
    setValue(Retried, count(statistics.retries));
    setValue(TimeOuts, count(statistics.timeouts));
    setValue(Refused, count(statistics.refused));
    setValue(WrongSums, count(statistics.badChecksum));
    setValue(SurplusBytes, count(statistics.surplusBytes));
    setValue(StaleBytes, count(statistics.staleBytes));
    setValue(Resyncs, count(statistics.resyncs));
    setValue(Rejected, count(statistics.rejected));
    int row = kFirstRows;
    for (const std::uint64_t rejections : statistics.rejections)
        setValue(row++, count(rejections));
}

}  // namespace nmc
