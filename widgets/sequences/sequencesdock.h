// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/lazydock.h"
#include "widgets/sequences/sequencespage.h"

namespace nmc {

/// The dock of points and sequences, closed initially; its content is built when it is first seen.
class SequencesDock : public LazyDock {
    Q_OBJECT

public:
    explicit SequencesDock(QWidget* parent = nullptr);

    // As in SequencesPage.
    void showSession(const LinkState& link, const Machine& machine);
    void showRun(const SequenceReport& report);
    void showForesight(const DryRun& dryRun) { page().showForesight(dryRun); }

    /// The content; built if necessary.
    SequencesPage& page();

signals:
    /// A run has ended, and neither the user nor a stop of all modules ended it.
    void ended();
    // As in SequencesPage.
    void programEdited(const nmc::Program& program);
    void goToRequested(const std::string& point);
    void startRequested(const std::string& sequence, std::size_t row, bool singleStep);
    void pauseRequested();
    void resumeRequested();
    void stepRequested();
    void stopRequested();
    void foresightRequested(const std::string& sequence, std::size_t row);
    void foresightDropped();

private:
    void build() override { page(); }
    SequencesPage* m_page = nullptr;
    std::optional<SequenceReport> m_run;
};

}  // namespace nmc
