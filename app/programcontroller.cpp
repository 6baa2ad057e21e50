// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/programcontroller.h"

#include "widgets/axes/axesdock.h"
#include "widgets/common/sequencetexts.h"
#include "widgets/paths/pathsdock.h"
#include "widgets/sequences/sequencesdock.h"

namespace nmc {

ProgramController::ProgramController(MainWindow& window, const BusStore& store, MachineController& machine,
                                     Commander& commander, MessageController& messages, QObject* parent)
    : QObject(parent),
      m_window(window),
      m_machine(machine),
      m_sequences(commander.sequences()),
      m_messages(messages) {
    SequencesDock& dock = m_window.sequences();
    connect(&dock, &SequencesDock::programEdited, &m_machine, &MachineController::editProgram);
    connect(&dock, &SequencesDock::goToRequested, this,
            [this](const std::string& point) { m_sequences.goTo(m_machine.machine(), point); });
    connect(&dock, &SequencesDock::startRequested, this,
            [this](const std::string& sequence, std::size_t row, bool singleStep) {
                m_sequences.start(m_machine.machine(), sequence, row, singleStep);
            });
    connect(&dock, &SequencesDock::pauseRequested, &m_sequences, &SequenceController::pause);
    connect(&dock, &SequencesDock::resumeRequested, &m_sequences, &SequenceController::resume);
    connect(&dock, &SequencesDock::stepRequested, &m_sequences, &SequenceController::step);
    connect(&dock, &SequencesDock::stopRequested, &m_sequences, &SequenceController::stop);
    connect(&dock, &SequencesDock::foresightRequested, this,
            [this](const std::string& sequence, std::size_t row) {
                m_sequences.foresee(m_machine.machine(), sequence, row);
            });
    connect(&dock, &SequencesDock::foresightDropped, &m_sequences, &SequenceController::endForesight);
    connect(&m_sequences, &SequenceController::foreseen, &dock, &SequencesDock::showForesight);
    connect(&m_sequences, &SequenceController::reported, this, &ProgramController::showRun);
    connect(&m_sequences, &SequenceController::refused, this,
            [this](const std::vector<SequenceProblem>& problems) {
                m_messages.report(texts::sequenceNotBegun(problems.front()));
            });
    PathsDock& paths = m_window.paths();
    connect(&paths, &PathsDock::openRequested, this,
            [this, &paths](const QString& file, const std::vector<PathColumn>& axes) {
                m_paths.open(file, axes, paths.page());
            });
    connect(&paths, &PathsDock::placeRequested, this, &ProgramController::goTo);
    AxesDock& axes = m_window.axes();
    connect(&axes, &AxesDock::homeOrderEdited, &m_machine, &MachineController::editHomeOrder);
    connect(&axes, &AxesDock::homeAllRequested, this, [this, &store] {
        m_sequences.home(m_machine.machine(), axesToHome(m_machine.machine(), store.link().modules));
    });
}

void ProgramController::showRun(const SequenceReport& report) {
    m_window.sequences().showRun(report);
    m_window.paths().showSequence(!report.over());
    if (const auto message = texts::sequenceOver(report))
        m_messages.report(*message);
}

/// The place is a point of this run only.
void ProgramController::goTo(const Point& place) {
    Machine machine = m_machine.machine();
    std::erase_if(machine.program.points, [&](const Point& point) { return point.name == place.name; });
    machine.program.points.push_back(place);
    m_sequences.goTo(machine, place.name);
}

}  // namespace nmc
