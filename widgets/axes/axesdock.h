// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/axes/axespage.h"
#include "widgets/common/lazydock.h"

namespace nmc {

/// The dock of the table of all axes, closed initially; its content is built when it is first seen.
class AxesDock : public PageDock<AxesPage> {
    Q_OBJECT

public:
    explicit AxesDock(Requests& requests, QWidget* parent = nullptr);

    // As in AxesPage.
    void showModules(const std::vector<PanelView>& views, const Machine& machine);
    void showSequence(bool running);

private:
    void showSoFar() override;

    bool m_sequenceRuns = false;
};

}  // namespace nmc
