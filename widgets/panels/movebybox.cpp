// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/movebybox.h"

#include <QCheckBox>
#include <QLabel>
#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/common/flowlayout.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/texts.h"
#include "widgets/panels/command.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr double kFirstDistance = 100;
constexpr double kMaxRounds = 100'000;
constexpr double kLongestPause = 3'600;  // s
constexpr int kRepeatDigits = 6;
}  // namespace

MoveByBox::MoveByBox(ModuleContext& context, const MovesBy& motion, QWidget* parent)
    : QGroupBox(parent), m_context(context), m_motion(motion) {
    look::name(this, m_context.named(u"moveByBox"_s), tr("Step by a distance"));
    auto* grid = new FormGrid(this);
    buildDistance(grid);
    buildRepeat(grid);
    m_distance->setScale(m_context.scale());
    m_distance->showNative(m_kept = kept());
    m_context.whenSeen(this, [this] { showModule(); });
}

void MoveByBox::buildDistance(FormGrid* grid) {
    m_distance = form::newQuantity({.kind = QuantityField::Kind::Distance,
                                    .name = m_context.named(u"moveByDistanceField"_s),
                                    .accessible = tr("Distance of a step"),
                                    .words = tr("The distance of a step"),
                                    .min = 1,
                                    .max = static_cast<double>(servo::kPositionRange.max),
                                    .meaning = tr("Distance per click, at the velocity of Go to.")},
                                   this);
    m_reverse = new Command({.name = m_context.named(u"moveByReverseButton"_s),
                             .text = Common::tr("◂| Step"),
                             .accessible = tr("Step in reverse")},
                            this, [this] { step(true); });
    m_forward = new Command({.name = m_context.named(u"moveByForwardButton"_s),
                             .text = Common::tr("Step |▸"),
                             .accessible = tr("Step forward")},
                            this, [this] { step(false); });
    form::setBold(grid->addRow(tr("Step by"), m_distance,
                               {form::newLine(this, {m_reverse->button(), m_forward->button()})}));
    connect(m_distance, &QuantityField::nativeEdited, this, [this] {
        refresh();
        if (const auto counts = m_distance->native())
            m_context.edit([counts](AxisSettings& axis) { axis.motion.stepSize = *counts; });
    });
}

void MoveByBox::buildRepeat(FormGrid* grid) {
    m_rounds = form::newNumber({.name = m_context.named(u"moveByRoundsField"_s),
                                .accessible = tr("The number of steps"),
                                .min = 1,
                                .max = kMaxRounds,
                                .digits = kRepeatDigits,
                                .meaning = tr("Number of steps per click.")},
                               this);
    m_rounds->showValue(1);
    m_pause = form::newNumber({.name = m_context.named(u"moveByPauseField"_s),
                               .accessible = tr("The pause between steps"),
                               .max = kLongestPause,
                               .decimals = 2,
                               .digits = kRepeatDigits,
                               .meaning = tr("Time to wait after each move, in seconds.")},
                              this);
    m_pause->showValue(0);
    for (NumberField* field : {m_rounds, m_pause})
        connect(field, &NumberField::edited, this, &MoveByBox::refresh);
    m_backAndForth = form::newCheck({.name = m_context.named(u"moveByBackAndForthBox"_s),
                                     .text = tr("there and back"),
                                     .accessible = tr("There and back with each step"),
                                     .meaning = tr("Each step goes there and back.")},
                                    this);
    connect(m_backAndForth, &QCheckBox::toggled, this, &MoveByBox::refresh);
    m_end = new Command({.name = m_context.named(u"moveByEndButton"_s),
                         .icon = u"player-stop"_s,
                         .text = tr("End steps"),
                         .accessible = tr("End steps and stop")},
                        this, [this] { m_context.ask(intent::CancelProcedure{}); });
    m_progress = look::newMutedLabel({}, this, m_context.named(u"moveByProgress"_s));
    auto* repeat =
        new FlowLayout(look::gridUnit(this),
                       {m_rounds, form::newLabel(tr("times, pause"), m_pause), m_pause,
                        new QLabel(Common::tr("s"), this), m_backAndForth, m_end->button(), m_progress});
    auto* title = new QLabel(tr("Repeat"), this);
    // The title is beside the first row if there are two.
    title->setMinimumHeight(m_rounds->sizeHint().height());
    grid->addWidget(title, grid->row(), 0, Qt::AlignTop);
    grid->addWide(repeat, 1);
}

double MoveByBox::kept() const {
    const double size = m_context.settings().motion.stepSize;
    return size > 0 ? size : kFirstDistance;
}

void MoveByBox::showModule() {
    m_distance->setScale(m_context.scale());
    const double before = std::exchange(m_kept, kept());
    m_distance->follow(m_kept, before);
    refresh();
    if (const QString reason = moveByTurns(); !reason.isEmpty())
        emit turnsDropped(reason);
}

QString MoveByBox::whyNotNow() const {
    if (const QString reason = m_context.reasonNow(IntentKind::Move); !reason.isEmpty())
        return reason;
    if (const QString reason = m_motion.whyNoMovesBy(); !reason.isEmpty())
        return reason;
    for (const NumberField* field : {static_cast<NumberField*>(m_distance), m_rounds, m_pause})
        if (const QString problem = field->problemText(); !problem.isEmpty())
            return problem;
    return {};
}

void MoveByBox::refreshStep(Command& command, bool reverse, const QString& reason, const QString& meaning) {
    const auto steps = wanted(reverse);
    command.setPossible(reason.isEmpty() && steps ? m_context.reasonFor(*steps) : reason, meaning);
}

QString MoveByBox::turn(int steps) {
    m_turns += steps;
    return moveByTurns();
}

/// What cannot be moved for another reason than the move that lasts is forgotten.
QString MoveByBox::moveByTurns() {
    if (m_turns == 0 || m_context.runs(ProcedureKind::MoveBy) || m_context.busy())
        return {};
    const double turns = std::exchange(m_turns, 0);
    const auto distance = m_distance->native();
    if (!distance)
        return m_distance->problemText();
    const double counts =
        std::min(std::abs(turns) * *distance, static_cast<double>(servo::kPositionRange.max));
    const auto move = m_motion.movesBy(
        {static_cast<std::int32_t>(m_context.chipReverse(turns < 0) ? -counts : counts), 1, 0.0, false});
    const QString reason = move ? m_context.reasonFor(*move) : m_motion.whyNoMovesBy();
    if (reason.isEmpty()) {
        m_turning = true;
        m_context.ask(*move);
    }
    return reason;
}

void MoveByBox::endTurns() {
    m_turns = 0;
    const auto running = m_context.runningProcedure();
    if (std::exchange(m_turning, false) && (!running || running->kind == ProcedureKind::MoveBy))
        m_context.ask(intent::CancelProcedure{});
}

void MoveByBox::refresh() {
    const std::optional<ProcedureReport> report = m_context.procedure(ProcedureKind::MoveBy);
    const bool running = m_context.runs(ProcedureKind::MoveBy);
    const QString reason = running ? tr("A series of steps is already running.") : whyNotNow();
    refreshStep(*m_forward, false, reason, tr("Moves forward by this distance, then holds."));
    refreshStep(*m_reverse, true, reason, tr("Moves in reverse by this distance, then holds."));
    m_end->setPossible(running ? QString() : tr("No series of steps is running."),
                       tr("Ends the series of steps and stops the motor smoothly."));
    QString progress;
    if (report && report->rounds > 1)
        progress =
            running ? tr("%1 of %2").arg(report->round).arg(report->rounds) : texts::procedureStage(*report);
    look::setText(m_progress, progress);
}

std::optional<Intent> MoveByBox::wanted(bool reverse) const {
    const auto distance = m_distance->native();
    const auto rounds = m_rounds->value();
    const auto pause = m_pause->value();
    if (!distance || !rounds || !pause)
        return std::nullopt;
    return m_motion.movesBy(
        {static_cast<std::int32_t>(m_context.chipReverse(reverse) ? -*distance : *distance),
         static_cast<unsigned>(*rounds), *pause, m_backAndForth->isChecked()});
}

void MoveByBox::step(bool reverse) {
    if (const auto steps = wanted(reverse))
        m_context.ask(*steps);
}

}  // namespace nmc
