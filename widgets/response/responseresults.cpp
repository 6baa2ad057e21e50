// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/response/responseresults.h"

#include <QHeaderView>
#include <array>

#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/response/responsewords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
enum Row {
    Number,
    Rise,
    Overshoot,
    Settling,
    AtRest,
    MoveTime,
    MoveSettling,
    Spread,
    PeakError,
    RmsError,
    SlewError,
    SteadyError,
    PeakPwm,
    Interval,
    kRows
};
constexpr std::array kOfSteps{Rise, Overshoot, Settling, AtRest, PeakPwm};
constexpr std::array kOfMoves{MoveTime, MoveSettling, Spread, PeakError, RmsError, SlewError};
}  // namespace

ResponseResults::ResponseResults(QWidget* parent) : QTableWidget(kRows, 2, parent) {
    look::name(this, u"responseResults"_s, tr("Results of the runs shown"));
    setHorizontalHeaderLabels({Common::tr("A"), Common::tr("B")});
    setVerticalHeaderLabels({tr("Run"), tr("Rise, 10 to 90 %"), Common::tr("Overshoot"),
                             tr("Settling to the goal"), tr("Settling to rest position"), tr("Move time"),
                             tr("Settling after the move"), tr("Settling, all moves"), tr("Peak error"),
                             tr("RMS error"), tr("Error at constant velocity"), tr("Steady-state error"),
                             tr("Peak PWM, of 255"), tr("Sample interval")});
    verticalHeaderItem(Rise)->setToolTip(tr("Time from 10 % to 90 % of the step."));
    verticalHeaderItem(Overshoot)->setToolTip(tr("How far the motor went past its goal, in % of the step."));
    verticalHeaderItem(Settling)->setToolTip(tr(
        "Time until the position stays within the settling band around the goal. Empty if that happens only in the last fifth of the record."));
    verticalHeaderItem(AtRest)->setToolTip(tr(
        "Time until the position stays within the settling band around the mean position of the last fifth of the record. Without integral gain (Ki, IL), friction holds a motor off its goal."));
    verticalHeaderItem(MoveTime)->setToolTip(
        tr("Duration of the commanded profile, calculated from distance, velocity and acceleration."));
    verticalHeaderItem(MoveSettling)
        ->setToolTip(tr(
            "Time from the end of the profile until the motor is in the window, where it stays for the dwell."));
    verticalHeaderItem(Spread)->setToolTip(
        tr("The shortest and the longest settling time of the moves there and back, and their number."));
    verticalHeaderItem(PeakError)->setToolTip(
        tr("The largest position error during the move and after it, without its sign."));
    verticalHeaderItem(RmsError)->setToolTip(tr("Root mean square of the position error during the move."));
    verticalHeaderItem(SlewError)->setToolTip(
        tr("Mean position error over the second half of the time at constant velocity."));
    verticalHeaderItem(SteadyError)
        ->setToolTip(tr("Goal minus the mean position over the last fifth of the record."));
    verticalHeaderItem(PeakPwm)->setToolTip(tr(
        "PWM demand at the jump, calculated from the gains. Later ticks may need more: below the output limit OL this is a lower bound."));
    verticalHeaderItem(Interval)->setToolTip(
        tr("Mean time between two positions of the record. It sets the accuracy of the results."));
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

void ResponseResults::showRun(int column, const KeptResponse* kept, std::span<const KeptResponse> runs) {
    QStringList cells(kRows, u"–"_s);
    if (kept != nullptr) {
        const ResponseMetrics& metrics = kept->run.metrics;
        cells[Number] = QString::number(kept->number);
        cells[Rise] = texts::responseTime(metrics.rise);
        cells[Overshoot] = texts::responseOvershoot(metrics.overshoot);
        cells[Settling] = texts::responseTime(metrics.settling);
        cells[AtRest] = texts::responseTime(metrics.settlingAtRest);
        cells[SteadyError] = texts::responseError(metrics.steadyError, kept->scale);
        cells[PeakPwm] = texts::peakPwm(kept->run.pwm);
        if (const auto& move = kept->run.move) {
            for (const Row row : kOfSteps)
                cells[row] = u"–"_s;
            cells[MoveTime] =
                texts::responseTime(Measured{move->moveTime, secondsPerTick(kept->run.taken.gains.sr)});
            cells[MoveSettling] = texts::responseTime(move->settling);
            if (!runs.empty())
                cells[Spread] = texts::settlingSpread(seriesOf(runs, *kept));
            cells[PeakError] = texts::responseErrorSize(move->peak, kept->scale);
            cells[RmsError] = texts::responseErrorSize(move->rms, kept->scale);
            cells[SlewError] = texts::responseError(move->slew, kept->scale);
        }
        cells[Interval] = Common::tr("%1 ms").arg(texts::readout(metrics.interval * 1e3, 3));
    }
    for (int row = 0; row < kRows; ++row) {
        auto* item = new QTableWidgetItem(cells[row]);
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        item->setToolTip(cells[row]);
        setItem(row, column, item);
    }
}

void ResponseResults::showRuns(const KeptResponse* a, const KeptResponse* b,
                               std::span<const KeptResponse> runs) {
    showRun(0, a, runs);
    showRun(1, b, runs);
    const auto isMove = [](const KeptResponse* kept) { return kept != nullptr && kept->run.taken.isMove(); };
    const bool moves = isMove(a) || isMove(b);
    const bool steps = !moves || (a != nullptr && !isMove(a)) || (b != nullptr && !isMove(b));
    for (const Row row : kOfSteps)
        setRowHidden(row, !steps);
    for (const Row row : kOfMoves)
        setRowHidden(row, !moves);
    updateGeometry();
}

QSize ResponseResults::sizeHint() const {
    const int rows = verticalHeader()->length() + horizontalHeader()->sizeHint().height();
    const int cell = fontMetrics().horizontalAdvance(u"\u2212100.0 ± 10.0 counts"_s);
    return {verticalHeader()->sizeHint().width() + 2 * cell, rows + 2 * frameWidth()};
}

}  // namespace nmc
