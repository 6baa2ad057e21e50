// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/programcontroller.h"

#include "widgets/axes/axespage.h"
#include "widgets/common/lazydock.h"
#include "widgets/common/requests.h"
#include "widgets/common/sequencetexts.h"
#include "widgets/paths/pathspage.h"
#include "widgets/sequences/sequencesdock.h"

namespace nmc {

ProgramController::ProgramController(MainWindow& window, const BusStore& store, MachineController& machine,
                                     Commander& commander, MessageController& messages)
    : m_window(window), m_machine(machine), m_sequences(commander.sequences()), m_messages(messages) {
    const Requests* requests = &m_window.requests();
    connect(requests, &Requests::programEdited, &m_machine, &MachineController::editProgram);
    connect(requests, &Requests::goToPoint, this, [this](const std::string& point) {
        m_sequences.begin(SequenceRun::toPoint(m_machine.machine(), point));
    });
    // The place is a point of this run only.
    connect(requests, &Requests::goToPlace, this, [this](const Point& place) {
        m_sequences.begin(SequenceRun::toPoint(withPlace(m_machine.machine(), place), place.name));
    });
    connect(requests, &Requests::startSequence, this,
            [this](const std::string& sequence, std::size_t row, bool singleStep) {
                m_sequences.begin(SequenceRun(m_machine.machine(), sequence, row, singleStep));
            });
    connect(requests, &Requests::pauseSequence, &m_sequences, &SequenceController::pause);
    connect(requests, &Requests::resumeSequence, &m_sequences, &SequenceController::resume);
    connect(requests, &Requests::stepSequence, &m_sequences, &SequenceController::step);
    connect(requests, &Requests::stopSequence, &m_sequences, &SequenceController::stop);
    connect(requests, &Requests::foresee, this, [this](const std::string& sequence, std::size_t row) {
        m_sequences.foresee(m_machine.machine(), sequence, row);
    });
    connect(requests, &Requests::foresightDropped, &m_sequences, &SequenceController::endForesight);
    connect(requests, &Requests::openPath, this,
            [this](const QString& file, const std::vector<PathColumn>& axes) {
                m_paths.open(file, axes, m_window.paths().page());
            });
    connect(requests, &Requests::homeOrderEdited, &m_machine, &MachineController::editHomeOrder);
    connect(requests, &Requests::homeAll, this, [this, &store] {
        m_sequences.begin(
            SequenceRun::homing(m_machine.machine(), axesToHome(m_machine.machine(), store.link().modules)));
    });
    connect(&m_sequences, &SequenceController::foreseen, &m_window.sequences(),
            &SequencesDock::showForesight);
    connect(&m_sequences, &SequenceController::reported, this, &ProgramController::showRun);
    connect(&m_sequences, &SequenceController::refused, this,
            [this](const std::vector<SequenceProblem>& problems) {
                m_messages.report(texts::sequenceNotBegun(problems.front()));
            });
}

void ProgramController::showRun(const SequenceReport& report) {
    m_window.sequences().showRun(report);
    const auto tell = [runs = !report.over()](auto& page) { page.showSequence(runs); };
    m_window.paths().tell(tell);
    m_window.axes().tell(tell);
    if (const auto message = texts::sequenceOver(report))
        m_messages.report(*message);
}

}  // namespace nmc
