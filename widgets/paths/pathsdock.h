// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/lazydock.h"
#include "widgets/paths/pathspage.h"

namespace nmc {

/// The dock of paths, closed initially; its content is built when it is first seen.
class PathsDock : public PageDock<PathsPage> {
    Q_OBJECT

public:
    explicit PathsDock(Requests& requests, QWidget* parent = nullptr);

    void showSession(const LinkState& link, const Machine& machine, const Session::Procedures& procedures);
    void showSequence(bool running);

private:
    void showSoFar() override { m_page->showSequence(m_sequenceRuns); }

    bool m_sequenceRuns = false;
};

}  // namespace nmc
