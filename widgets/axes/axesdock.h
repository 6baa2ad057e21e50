// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>

#include "widgets/axes/axespage.h"

namespace nmc {

/// The place of the table of all axes, closed at first: its content is built when it is seen for the first
/// time.
class AxesDock : public QDockWidget {
    Q_OBJECT

public:
    explicit AxesDock(QWidget* parent = nullptr);

    /// Whether showModules() would be seen.
    [[nodiscard]] bool seen() const { return m_seen; }
    // As in AxesPage.
    void showModules(const std::vector<PanelView>& views, const Machine& machine);
    void forgetModules();
    void endHold();
    void setHoldInterval(int milliseconds);

signals:
    /// It can be seen, and what it shows may be old.
    void opened();
    // As in AxesPage.
    void intentRequested(nmc::ModuleIndex module, const nmc::Intent& intent);
    void holdRequested(const nmc::bus::HoldToMove& hold);
    void holdReleased();
    void homeAllRequested();
    void homeOrderEdited(const std::vector<nmc::ModuleIndex>& order);

private:
    AxesPage& page();

    AxesPage* m_page = nullptr;
    bool m_seen = false;
    int m_holdInterval = 100;
};

}  // namespace nmc
