// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/response/stepresults.h"

#include <QHeaderView>

#include "widgets/common/look.h"
#include "widgets/common/words.h"
#include "widgets/response/stepresponsewords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
enum Row { Number, Rise, Overshoot, Settling, AtRest, SteadyError, PeakPwm, Interval, kRows };
}

StepResults::StepResults(QWidget* parent) : QTableWidget(kRows, 2, parent) {
    look::name(this, u"stepResults"_s, tr("What the runs that are shown come to"));
    setHorizontalHeaderLabels({tr("A"), tr("B")});
    setVerticalHeaderLabels({tr("Run"), tr("Rise, 10 to 90 %"), tr("Overshoot"), tr("Settling to the goal"),
                             tr("Settling where it stays"), tr("Steady-state error"), tr("Peak PWM, of 255"),
                             tr("Sample interval")});
    verticalHeaderItem(Rise)->setToolTip(tr("Time from 10 % to 90 % of the step."));
    verticalHeaderItem(Overshoot)->setToolTip(tr("How far it went beyond its goal, in % of the step."));
    verticalHeaderItem(Settling)->setToolTip(tr(
        "Time until it stays within the settling band around the goal. Nothing if that is not before the last fifth of the record."));
    verticalHeaderItem(AtRest)->setToolTip(tr(
        "The same around the mean position of the last fifth of the record. Friction holds a motor beside its goal unless there is an integral (Ki, IL)."));
    verticalHeaderItem(SteadyError)
        ->setToolTip(tr("Goal less the mean position of the last fifth of the record."));
    verticalHeaderItem(PeakPwm)->setToolTip(tr(
        "What the servo asks of the amplifier when the command jumps, from the gains. A later tick may ask for more, so below the output limit OL it is only a lower bound."));
    verticalHeaderItem(Interval)->setToolTip(
        tr("The mean time between two positions of the record. The doubts come from it."));
    setFont(look::tabular(look::scaled(font(), 0.9)));
    horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() * 3 / 2);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionMode(QAbstractItemView::NoSelection);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setTabKeyNavigation(false);
    showRuns(nullptr, nullptr);
}

void StepResults::showRun(int column, const KeptRun* kept) {
    QStringList cells(kRows, u"–"_s);
    if (kept != nullptr) {
        const StepMetrics& metrics = kept->run.metrics;
        cells[Number] = QString::number(kept->number);
        cells[Rise] = texts::stepTime(metrics.rise);
        cells[Overshoot] = texts::stepOvershoot(metrics.overshoot);
        cells[Settling] = texts::stepTime(metrics.settling);
        cells[AtRest] = texts::stepTime(metrics.settlingAtRest);
        cells[SteadyError] = texts::stepError(metrics.steadyError, kept->scale);
        cells[PeakPwm] = texts::peakPwm(kept->run.pwm);
        cells[Interval] = tr("%1 ms").arg(texts::readout(metrics.interval * 1e3, 3));
    }
    for (int row = 0; row < kRows; ++row) {
        auto* item = new QTableWidgetItem(cells[row]);
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        item->setToolTip(cells[row]);
        setItem(row, column, item);
    }
}

void StepResults::showRuns(const KeptRun* a, const KeptRun* b) {
    showRun(0, a);
    showRun(1, b);
}

QSize StepResults::sizeHint() const {
    const int rows = verticalHeader()->length() + horizontalHeader()->sizeHint().height();
    const int cell = fontMetrics().horizontalAdvance(u"\u2212100.0 ± 10.0 counts"_s);
    return {verticalHeader()->sizeHint().width() + 2 * cell, rows + 2 * frameWidth()};
}

}  // namespace nmc
