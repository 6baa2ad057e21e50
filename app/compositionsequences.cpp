// SPDX-License-Identifier: GPL-3.0-or-later
// Points, sequences and requests to all axes: from the window, and their progress.
#include "app/composition.h"
#include "widgets/axes/axesdock.h"
#include "widgets/common/sequencetexts.h"
#include "widgets/paths/pathsdock.h"
#include "widgets/sequences/sequencesdock.h"

namespace nmc {

void Composition::wireSequences() {
    SequencesDock& dock = m_window.sequences();
    SequenceController& sequences = m_commander.sequences();
    connect(&dock, &SequencesDock::programEdited, &m_machine, &MachineController::editProgram);
    connect(&dock, &SequencesDock::goToRequested, this,
            [this](const std::string& point) { m_commander.sequences().goTo(m_machine.machine(), point); });
    connect(&dock, &SequencesDock::startRequested, this,
            [this](const std::string& sequence, std::size_t row, bool singleStep) {
                m_commander.sequences().start(m_machine.machine(), sequence, row, singleStep);
            });
    connect(&dock, &SequencesDock::pauseRequested, &sequences, &SequenceController::pause);
    connect(&dock, &SequencesDock::resumeRequested, &sequences, &SequenceController::resume);
    connect(&dock, &SequencesDock::stepRequested, &sequences, &SequenceController::step);
    connect(&dock, &SequencesDock::stopRequested, &sequences, &SequenceController::stop);
    connect(&dock, &SequencesDock::foresightRequested, this,
            [this](const std::string& sequence, std::size_t row) {
                m_commander.sequences().foresee(m_machine.machine(), sequence, row);
            });
    connect(&dock, &SequencesDock::foresightDropped, &sequences, &SequenceController::endForesight);
    connect(&sequences, &SequenceController::foreseen, &dock, &SequencesDock::showForesight);
    connect(&sequences, &SequenceController::reported, this, &Composition::showSequence);
    connect(&sequences, &SequenceController::refused, this,
            [this](const std::vector<SequenceProblem>& problems) {
                m_messages.report(texts::sequenceNotBegun(problems.front()));
            });
    PathsDock& paths = m_window.paths();
    connect(&paths, &PathsDock::openRequested, this,
            [this, &paths](const QString& file, const std::vector<PathColumn>& axes) {
                m_paths.open(file, axes, paths.page());
            });
    connect(&paths, &PathsDock::placeRequested, this, [this](const Point& place) {
        Machine machine = m_machine.machine();
        std::erase_if(machine.program.points, [&](const Point& point) { return point.name == place.name; });
        machine.program.points.push_back(place);
        m_commander.sequences().goTo(machine, place.name);
    });
    AxesDock& axes = m_window.axes();
    connect(&axes, &AxesDock::homeOrderEdited, &m_machine, &MachineController::editHomeOrder);
    connect(&axes, &AxesDock::homeAllRequested, this, [this] {
        m_commander.sequences().home(m_machine.machine(),
                                     axesToHome(m_machine.machine(), m_store.link().modules));
    });
}

void Composition::showSequence(const SequenceReport& report) {
    m_window.sequences().showRun(report);
    m_window.paths().showSequence(!report.over());
    if (const auto message = texts::sequenceOver(report))
        m_messages.report(*message);
    if (report.over() && m_scanWhenIdle)
        scanAgain();
}

}  // namespace nmc
