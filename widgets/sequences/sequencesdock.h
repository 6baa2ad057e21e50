// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/lazydock.h"
#include "widgets/sequences/sequencespage.h"

namespace nmc {

/// The dock of points and sequences, closed initially; its content is built when it is first seen.
class SequencesDock : public PageDock<SequencesPage> {
    Q_OBJECT

public:
    explicit SequencesDock(Requests& requests, QWidget* parent = nullptr);

    // As in SequencesPage.
    void showSession(const LinkState& link, const Machine& machine);
    void showRun(const SequenceReport& report);
    void showForesight(const DryRun& dryRun) { page().showForesight(dryRun); }

signals:
    /// A run has ended, and neither the user nor a stop of all modules ended it.
    void ended();

private:
    void showSoFar() override;
    [[nodiscard]] QWidget* framed() override { return m_page; }

    std::optional<SequenceReport> m_run;
};

}  // namespace nmc
