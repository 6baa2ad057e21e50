// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/response/stepruntable.h"

#include <QDateTime>
#include <QHeaderView>
#include <QLocale>
#include <QSignalBlocker>

#include "widgets/common/look.h"
#include "widgets/response/stepresponsewords.h"

namespace nmc {

using namespace Qt::StringLiterals;

StepRunTable::StepRunTable(QWidget* parent) : QTableWidget(0, Settling + 1, parent) {
    look::name(this, u"stepRunTable"_s, tr("Step responses so far"));
    setToolTip(tr("The step responses so far, newest first. Tick two of them to compare their curves."));
    setHorizontalHeaderLabels({tr("A"), tr("B"), tr("Run"), tr("Module"), tr("Time"), u"Kp"_s, u"Kd"_s,
                               u"Ki"_s, tr("Overshoot"), tr("Settling")});
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setMinimumSectionSize(fontMetrics().height());
    horizontalHeader()->setHighlightSections(false);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() * 3 / 2);
    setFont(look::tabular(look::scaled(font(), 0.9)));
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setTabKeyNavigation(false);
    setWordWrap(false);
    connect(this, &QTableWidget::itemChanged, this, [this](const QTableWidgetItem* item) {
        emit shownWanted(item->column(), cell(item->row(), Run)->text().toInt(),
                         item->checkState() == Qt::Checked);
    });
    connect(this, &QTableWidget::itemSelectionChanged, this, &StepRunTable::chosenChanged);
}

QTableWidgetItem* StepRunTable::cell(int row, int column) {
    QTableWidgetItem* item = this->item(row, column);
    if (item == nullptr) {
        item = new QTableWidgetItem;
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
        if (column <= B)
            item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
        else
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        setItem(row, column, item);
    }
    return item;
}

void StepRunTable::showRun(int row, const KeptRun& kept, const ShownRuns& shown) {
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
    const QDateTime started =
        QDateTime::fromString(QString::fromStdString(kept.startedAt), Qt::ISODateWithMs);
    cell(row, Run)->setText(QString::number(kept.number));
    cell(row, Module)->setText(QString::number(kept.run.module.value() + 1));
    cell(row, Module)->setToolTip(QString::fromStdString(kept.moduleName));
    cell(row, Time)->setText(QLocale().toString(started.time(), u"HH:mm:ss"_s));
    cell(row, Kp)->setText(QString::number(gains.kp));
    cell(row, Kd)->setText(QString::number(gains.kd));
    cell(row, Ki)->setText(QString::number(gains.ki));
    cell(row, Overshoot)->setText(texts::stepOvershoot(kept.run.metrics.overshoot));
    cell(row, Settling)->setText(texts::stepSettling(kept.run.metrics));
}

void StepRunTable::showRuns(const std::vector<KeptRun>& runs, const ShownRuns& shown) {
    const std::optional<int> before = chosen();
    const QSignalBlocker blocker(this);
    setRowCount(static_cast<int>(runs.size()));
    int row = 0;
    for (auto kept = runs.rbegin(); kept != runs.rend(); ++kept, ++row) {
        showRun(row, *kept, shown);
        if (kept->number == before)
            setCurrentCell(row, currentColumn());
    }
}

std::optional<int> StepRunTable::chosen() const {
    const QTableWidgetItem* number = currentRow() >= 0 ? item(currentRow(), Run) : nullptr;
    return number != nullptr ? std::optional(number->text().toInt()) : std::nullopt;
}

QSize StepRunTable::sizeHint() const {
    return {fontMetrics().height() * 20, fontMetrics().height() * 7};
}

QSize StepRunTable::minimumSizeHint() const {
    return {fontMetrics().height() * 14, fontMetrics().height() * 5};
}

}  // namespace nmc
