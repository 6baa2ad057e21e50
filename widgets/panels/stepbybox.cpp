// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/stepbybox.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/numberfield.h"
#include "widgets/common/quantityfield.h"
#include "widgets/common/texts.h"
#include "widgets/panels/quantitygrid.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr double kFirstDistance = 100;
constexpr double kMostRounds = 100'000;
constexpr double kLongestPause = 3'600;  // s
}  // namespace

StepByBox::StepByBox(QWidget* parent) : QGroupBox(parent) {
    look::name(this, u"stepByBox"_s, tr("Step by a distance"));
    QGridLayout* grid = quantitygrid::newGrid(this);
    int line = 0;
    quantitygrid::addTitle(grid, line++, tr("Step by"),
                           tr("one click is one move of this distance, at the velocity of Go to"));
    buildDistance(grid, line);
    buildRepeat(grid, line);
    m_distance->showNative(kFirstDistance);
    refresh();
}

void StepByBox::buildDistance(QGridLayout* grid, int& line) {
    m_distance = new QuantityField(QuantityField::Kind::Position, this);
    m_distance->setName(u"stepSizeField"_s, tr("Distance of a step"));
    m_distance->setQuantity(tr("The distance of a step"));
    m_distance->setNativeRange(1, static_cast<double>(servo::kPositionRange.max));
    m_distance->setMeaning(tr("How far one click moves the motor."));
    quantitygrid::addRow(grid, line, tr("Distance"), m_distance);
    m_reverse = new QPushButton(tr("◂| Step"), this);
    look::name(m_reverse, u"stepReverseButton"_s, tr("One step in reverse"));
    m_forward = new QPushButton(tr("Step |▸"), this);
    look::name(m_forward, u"stepForwardButton"_s, tr("One step forward"));
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(look::gridUnit(this));
    buttons->addWidget(m_reverse);
    buttons->addWidget(m_forward);
    grid->addLayout(buttons, line++, quantitygrid::kButtonColumn);
    connect(m_distance, &QuantityField::nativeEdited, this, [this] {
        refresh();
        if (const auto counts = m_distance->native(); counts && m_module) {
            m_settings.motion.stepSize = *counts;
            emit settingsEdited([counts](AxisSettings& axis) { axis.motion.stepSize = *counts; });
        }
    });
    connect(m_reverse, &QPushButton::clicked, this, [this] { step(true); });
    connect(m_forward, &QPushButton::clicked, this, [this] { step(false); });
}

void StepByBox::buildRepeat(QGridLayout* grid, int& line) {
    const auto newField = [this](int decimals, const QString& objectName, const QString& name, double min,
                                 double max, double value, const QString& meaning) {
        auto* field = new NumberField(decimals, this);
        look::name(field, objectName, name);
        field->setWords(name, {});
        field->setRange(min, max);
        field->setDigits(6);
        field->setMeaning(meaning);
        field->showValue(value);
        connect(field, &NumberField::edited, this, &StepByBox::refresh);
        return field;
    };
    m_rounds = newField(0, u"stepRoundsField"_s, tr("The number of steps"), 1, kMostRounds, 1,
                        tr("How many steps one click makes."));
    m_pause = newField(2, u"stepPauseField"_s, tr("The pause between steps"), 0, kLongestPause, 0,
                       tr("Seconds to wait after each move."));
    m_backAndForth = new QCheckBox(tr("there and back"), this);
    look::name(m_backAndForth, u"stepBackAndForthBox"_s, tr("Each step there and back"));
    m_backAndForth->setToolTip(tr("Each step goes there and back again."));
    m_end = new QPushButton(icons::tinted(u"player-stop"_s), tr("End steps"), this);
    look::name(m_end, u"stepEndButton"_s, tr("End the steps and stop"));
    m_progress = look::newMutedLabel({}, this);
    m_progress->setObjectName(u"stepProgress"_s);
    auto* repeat = new QHBoxLayout;
    repeat->setSpacing(look::gridUnit(this));
    repeat->addWidget(m_rounds);
    repeat->addWidget(new QLabel(tr("times, pause"), this));
    repeat->addWidget(m_pause);
    repeat->addWidget(new QLabel(tr("s"), this));
    repeat->addWidget(m_backAndForth);
    repeat->addWidget(m_progress, 1);
    repeat->addWidget(m_end);
    grid->addWidget(new QLabel(tr("Repeat"), this), line, 0);
    grid->addLayout(repeat, line++, 1, 1, quantitygrid::kColumns - 1);
    connect(m_end, &QPushButton::clicked, this, [this] { emit intentRequested(intent::CancelProcedure{}); });
}

void StepByBox::showModule(const PanelView& view, const Pace& pace) {
    const bool another = !m_module || m_module->info.index != view.module.info.index;
    const auto distanceOf = [](const AxisSettings& settings) {
        return settings.motion.stepSize > 0 ? settings.motion.stepSize : kFirstDistance;
    };
    const double before = distanceOf(m_settings);
    m_module = view.module;
    m_settings = view.settings;
    m_pace = pace;
    m_connected = view.connected;
    m_report.reset();
    if (view.procedure != nullptr && view.procedure->kind == ProcedureKind::StepBy)
        m_report = *view.procedure;
    m_distance->setScale(view.scale());
    if (another)
        m_distance->showNative(distanceOf(m_settings));
    else
        quantitygrid::follow(m_distance, distanceOf(m_settings), before);
    refresh();
}

void StepByBox::setBusy(bool busy) {
    if (m_busy == busy)
        return;
    m_busy = busy;
    refresh();
}

QString StepByBox::whyNotNow() const {
    if (!m_connected || !m_module)
        return texts::refusal(Refusal::NotConnected);
    if (const auto refusal = whyNot(Request::Move, *m_module))
        return texts::refusal(*refusal);
    if (m_busy)
        return tr("Waiting for the module's answer.");
    if (!m_pace.velocity)
        return texts::refusal(Refusal::NoVelocity);
    if (!m_pace.acceleration)
        return texts::refusal(Refusal::NoAcceleration);
    for (const NumberField* field : {static_cast<NumberField*>(m_distance), m_rounds, m_pause})
        if (const QString problem = field->problemText(); !problem.isEmpty())
            return problem;
    return {};
}

void StepByBox::refresh() {
    const bool running = m_report && !m_report->over();
    const QString reason = running ? tr("Steps are being made already.") : whyNotNow();
    look::setPossible(m_forward, reason, tr("Moves forward by this distance, and holds there."));
    look::setPossible(m_reverse, reason, tr("Moves in reverse by this distance, and holds there."));
    look::setPossible(m_end, running ? QString() : tr("No steps are being made."),
                      tr("Makes no more steps, and stops the motor smoothly."));
    QString progress;
    if (m_report && m_report->rounds > 1)
        progress = running ? tr("%1 of %2").arg(m_report->round).arg(m_report->rounds)
                           : texts::procedureStage(*m_report);
    look::setText(m_progress, progress);
}

void StepByBox::step(bool reverse) {
    const auto distance = m_distance->native();
    const auto rounds = m_rounds->value();
    const auto pause = m_pause->value();
    if (!m_forward->isEnabled() || !distance || !rounds || !pause || !m_pace.velocity || !m_pace.acceleration)
        return;
    intent::StepBy wanted;
    wanted.counts = static_cast<std::int32_t>(reverse ? -*distance : *distance);
    wanted.velocity = *m_pace.velocity;
    wanted.acceleration = *m_pace.acceleration;
    wanted.rounds = static_cast<unsigned>(*rounds);
    wanted.pause = *pause;
    wanted.backAndForth = m_backAndForth->isChecked();
    emit intentRequested(wanted);
}

}  // namespace nmc
