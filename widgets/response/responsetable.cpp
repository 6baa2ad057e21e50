// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/response/responsetable.h"

#include <QDateTime>
#include <QHeaderView>
#include <QLocale>
#include <QSignalBlocker>
#include <algorithm>
#include <tuple>

#include "model/machinefile/responsestore.h"
#include "widgets/common/dates.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/response/responsewords.h"

namespace nmc {

using namespace Qt::StringLiterals;

ResponseTable::ResponseTable(QWidget* parent) : QTableWidget(0, kColumns, parent) {
    look::name(this, u"responseRunTable"_s, tr("Step responses so far"));
    setToolTip(
        tr("Step responses, newest first. Select two check boxes to compare the curves. The last %1 are saved with the machine; those with a name or a note are kept longest.")
            .arg(kMaxKeptRuns));
    setHorizontalHeaderLabels({Common::tr("A"), Common::tr("B"), tr("Run"), Common::tr("Name"),
                               Common::tr("Module"), tr("Time"), u"Kp"_s, u"Kd"_s, u"Ki"_s,
                               Common::tr("Overshoot"), tr("Settling"), tr("Note")});
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setMinimumSectionSize(fontMetrics().height());
    horizontalHeader()->setHighlightSections(false);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() * 3 / 2);
    setFont(look::tabular(look::scaled(font(), 0.9)));
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    setTabKeyNavigation(false);
    setWordWrap(false);
    connect(this, &QTableWidget::itemChanged, this, [this](const QTableWidgetItem* item) {
        const int row = item->row();
        if (item->column() <= B)
            emit shownWanted(item->column(), numberAt(row), item->checkState() == Qt::Checked);
        else
            emit named(numberAt(row), cell(row, Name)->text(), cell(row, Note)->text());
    });
    connect(this, &QTableWidget::itemSelectionChanged, this, &ResponseTable::chosenChanged);
}

QTableWidgetItem* ResponseTable::cell(int row, int column) {
    QTableWidgetItem* item = this->item(row, column);
    if (item == nullptr) {
        item = new QTableWidgetItem;
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
        if (column <= B)
            item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
        else if (column == Name || column == Note)
            item->setFlags(item->flags() | Qt::ItemIsEditable);
        else
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        setItem(row, column, item);
    }
    return item;
}

void ResponseTable::showRun(int row, const KeptResponse& kept, const ShownRuns& shown) {
    const servo::SetGain& gains = kept.run.taken.gains;
    for (const int which : {A, B}) {
        QTableWidgetItem* box = cell(row, which);
        box->setCheckState(shown[static_cast<std::size_t>(which)] == kept.number ? Qt::Checked
                                                                                 : Qt::Unchecked);
        box->setData(Qt::AccessibleTextRole,
                     (which == A ? tr("Run %1 as A") : tr("Run %1 as B")).arg(kept.number));
        box->setToolTip(which == A ? tr("Draws this run as A, with a solid line.")
                                   : tr("Draws this run as B, with a dashed line."));
    }
    const QDateTime started = dateIn(kept.startedAt);
    cell(row, Run)->setText(QString::number(kept.number));
    for (const auto& [column, words, hint] :
         {std::tuple{Name, &kept.name, tr("Name of the run. Double-click or press F2 to edit.")},
          std::tuple{Note, &kept.note, tr("Note on the run. Double-click or press F2 to edit.")}}) {
        // Only if it has changed, because an editor may be open on it.
        const QString text = QString::fromStdString(*words);
        if (cell(row, column)->text() != text)
            cell(row, column)->setText(text);
        if (const QString tip = text.isEmpty() ? hint : text; cell(row, column)->toolTip() != tip)
            cell(row, column)->setToolTip(tip);
    }
    cell(row, Module)->setText(QString::number(kept.run.module.value() + 1));
    cell(row, Module)->setToolTip(QString::fromStdString(kept.moduleName));
    const bool today = started.date() == QDate::currentDate();
    cell(row, Time)->setText(today ? QLocale().toString(started.time(), u"HH:mm:ss"_s)
                                   : QLocale().toString(started, QLocale::ShortFormat));
    cell(row, Time)->setToolTip(Common::tr("%1, %2").arg(QLocale().toString(started, QLocale::LongFormat),
                                                         texts::portName(QString::fromStdString(kept.port))));
    cell(row, Kp)->setText(QString::number(gains.kp));
    cell(row, Kd)->setText(QString::number(gains.kd));
    cell(row, Ki)->setText(QString::number(gains.ki));
    cell(row, Overshoot)->setText(texts::responseOvershoot(kept.run.metrics.overshoot));
    cell(row, Settling)->setText(texts::responseSettling(kept.run));
}

void ResponseTable::showRuns(const std::vector<KeptResponse>& runs, const ShownRuns& shown) {
    const std::optional<int> before = chosen();
    {
        const QSignalBlocker blocker(this);
        arrangeRows(runs);
        int row = 0;
        for (auto kept = runs.rbegin(); kept != runs.rend(); ++kept, ++row)
            showRun(row, *kept, shown);
        if (chosen() != before)
            setCurrentCell(-1, -1);  // the user has not chosen its neighbour
    }
    if (chosen() != before)
        emit chosenChanged();
}

/// Each row stays with its run, and so do the selection and an open editor.
void ResponseTable::arrangeRows(const std::vector<KeptResponse>& runs) {
    int row = 0;
    for (auto kept = runs.rbegin(); kept != runs.rend(); ++kept, ++row) {
        const auto wanted = [&](int number) {
            return std::any_of(kept, runs.rend(),
                               [=](const KeptResponse& run) { return run.number == number; });
        };
        while (row < rowCount() && !wanted(numberAt(row)))
            removeRow(row);
        if (row == rowCount() || numberAt(row) != kept->number) {
            insertRow(row);
            cell(row, Run)->setText(QString::number(kept->number));
        }
    }
    setRowCount(row);
}

int ResponseTable::numberAt(int row) const {
    const QTableWidgetItem* number = item(row, Run);
    return number != nullptr ? number->text().toInt() : 0;
}

std::optional<int> ResponseTable::chosen() const {
    return currentRow() >= 0 ? std::optional(numberAt(currentRow())) : std::nullopt;
}

QSize ResponseTable::sizeHint() const {
    return {fontMetrics().height() * 20, fontMetrics().height() * 7};
}

QSize ResponseTable::minimumSizeHint() const {
    return {fontMetrics().height() * 14, fontMetrics().height() * 5};
}

}  // namespace nmc
