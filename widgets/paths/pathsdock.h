// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/lazydock.h"
#include "widgets/paths/pathspage.h"

namespace nmc {

class Requests;

/// The dock of paths, closed initially; its content is built when it is first seen.
class PathsDock : public LazyDock {
    Q_OBJECT

public:
    explicit PathsDock(Requests& requests, QWidget* parent = nullptr);

    void showSession(const LinkState& link, const Machine& machine, const Session::Procedures& procedures);
    void showSequence(bool running);
    [[nodiscard]] PathsPage& page();

private:
    void build() override { std::ignore = page(); }

    Requests& m_requests;
    PathsPage* m_page = nullptr;
    bool m_sequenceRuns = false;
};

}  // namespace nmc
