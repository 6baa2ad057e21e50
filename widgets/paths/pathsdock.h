// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tuple>

#include "widgets/common/lazydock.h"
#include "widgets/paths/pathspage.h"

namespace nmc {

/// The dock of paths, closed initially; its content is built when it is first seen.
class PathsDock : public LazyDock {
    Q_OBJECT

public:
    explicit PathsDock(QWidget* parent = nullptr);

    void showSession(const LinkState& link, const Machine& machine, const Session::Procedures& procedures);
    void showSequence(bool running);
    /// The delay that the adapter adds to each reply.
    void setLatency(Duration latency);
    [[nodiscard]] PathsPage& page();

signals:
    void openRequested(const QString& file, const std::vector<nmc::PathColumn>& axes);
    void saveRequested(const QString& file, const nmc::FileContent& content);
    void placeRequested(const nmc::Point& place);
    void asked(nmc::ModuleIndex module, const nmc::Intent& intent);

private:
    void build() override { std::ignore = page(); }

    PathsPage* m_page = nullptr;
    Duration m_latency{};
    bool m_sequenceRuns = false;
};

}  // namespace nmc
