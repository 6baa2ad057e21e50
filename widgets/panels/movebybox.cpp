// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/movebybox.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <utility>

#include "widgets/common/flowlayout.h"
#include "widgets/common/look.h"
#include "widgets/common/numberfield.h"
#include "widgets/common/quantityfield.h"
#include "widgets/common/texts.h"
#include "widgets/panels/command.h"
#include "widgets/panels/quantitygrid.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr double kFirstDistance = 100;
constexpr double kMaxRounds = 100'000;
constexpr double kLongestPause = 3'600;  // s
}  // namespace

MoveByBox::MoveByBox(ModuleContext& context, const MovesBy& motion, QWidget* parent)
    : QGroupBox(parent), m_context(context), m_motion(motion) {
    look::name(this, named(u"moveByBox"_s), tr("Step by a distance"));
    QGridLayout* grid = quantitygrid::newGrid(this);
    int line = 0;
    buildDistance(grid, line);
    buildRepeat(grid, line);
    m_distance->setScale(m_context.scale());
    m_distance->showNative(m_shown = kept());
    m_context.whenSeen(this, [this] { showModule(); });
}

QString MoveByBox::named(const QString& name) const {
    return look::nameFor(m_context.state().info.identity.type, name);
}

void MoveByBox::buildDistance(QGridLayout* grid, int& line) {
    m_distance = new QuantityField(QuantityField::Kind::Distance, this);
    m_distance->setName(named(u"moveByDistanceField"_s), tr("Distance of a step"));
    m_distance->setQuantity(tr("The distance of a step"));
    m_distance->setNativeRange(1, static_cast<double>(servo::kPositionRange.max));
    m_distance->setMeaning(tr("Distance per click, at the velocity of Go to."));
    quantitygrid::addFirstRow(grid, line, tr("Step by"), m_distance);
    m_reverse = new Command({.name = named(u"moveByReverseButton"_s),
                             .icon = {},
                             .text = tr("◂| Step"),
                             .accessible = tr("Step in reverse")},
                            this, [this] { step(true); });
    m_forward = new Command({.name = named(u"moveByForwardButton"_s),
                             .icon = {},
                             .text = tr("Step |▸"),
                             .accessible = tr("Step forward")},
                            this, [this] { step(false); });
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(look::gridUnit(this));
    buttons->addWidget(m_reverse->button());
    buttons->addWidget(m_forward->button());
    grid->addLayout(buttons, line++, quantitygrid::kButtonColumn);
    connect(m_distance, &QuantityField::nativeEdited, this, [this] {
        refresh();
        if (const auto counts = m_distance->native()) {
            m_shown = *counts;
            m_context.edit([counts](AxisSettings& axis) { axis.motion.stepSize = *counts; });
        }
    });
}

void MoveByBox::buildRepeat(QGridLayout* grid, int& line) {
    const auto newField = [this](int decimals, const QString& objectName, const QString& name, double min,
                                 double max, double value, const QString& meaning) {
        auto* field = new NumberField(decimals, this);
        look::name(field, objectName, name);
        field->setWords(name, {});
        field->setRange(min, max);
        field->setDigits(6);
        field->setMeaning(meaning);
        field->showValue(value);
        connect(field, &NumberField::edited, this, &MoveByBox::refresh);
        return field;
    };
    m_rounds = newField(0, named(u"moveByRoundsField"_s), tr("The number of steps"), 1, kMaxRounds, 1,
                        tr("Number of steps per click."));
    m_pause = newField(2, named(u"moveByPauseField"_s), tr("The pause between steps"), 0, kLongestPause, 0,
                       tr("Time to wait after each move, in seconds."));
    m_backAndForth = new QCheckBox(tr("there and back"), this);
    look::name(m_backAndForth, named(u"moveByBackAndForthBox"_s), tr("There and back with each step"));
    m_backAndForth->setToolTip(tr("Each step goes there and back."));
    connect(m_backAndForth, &QCheckBox::toggled, this, &MoveByBox::refresh);
    m_end = new Command({.name = named(u"moveByEndButton"_s),
                         .icon = u"player-stop"_s,
                         .text = tr("End steps"),
                         .accessible = tr("End steps and stop")},
                        this, [this] { m_context.ask(intent::CancelProcedure{}); });
    m_progress = look::newMutedLabel({}, this);
    m_progress->setObjectName(named(u"moveByProgress"_s));
    auto* pause = new QLabel(tr("times, pause"), this);
    pause->setBuddy(m_pause);
    auto* repeat = new FlowLayout(look::gridUnit(this));
    for (QWidget* part : std::initializer_list<QWidget*>{m_rounds, pause, m_pause, new QLabel(tr("s"), this),
                                                         m_backAndForth, m_end->button(), m_progress})
        repeat->addWidget(part);
    auto* title = new QLabel(tr("Repeat"), this);
    // The title is beside the first row if there are two.
    title->setMinimumHeight(m_rounds->sizeHint().height());
    grid->addWidget(title, line, 0, Qt::AlignTop);
    grid->addLayout(repeat, line++, 1, 1, quantitygrid::kColumns - 1);
}

double MoveByBox::kept() const {
    const double size = m_context.settings().motion.stepSize;
    return size > 0 ? size : kFirstDistance;
}

void MoveByBox::showModule() {
    m_distance->setScale(m_context.scale());
    const double before = std::exchange(m_shown, kept());
    quantitygrid::follow(m_distance, m_shown, before);
    refresh();
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

void MoveByBox::refresh() {
    const std::optional<ProcedureReport> report = m_context.procedure(ProcedureKind::MoveBy);
    const bool running = report && !report->over();
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
