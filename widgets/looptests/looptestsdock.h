// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/lazydock.h"
#include "widgets/panels/panelview.h"

class QPushButton;
class QTabWidget;

namespace nmc {

class FrequencyPage;
class Requests;
class SquareWavePage;

/// The dock of the longer tests of a loop, closed initially; its content is built when it is first seen, or
/// when a test reports.
class LoopTestsDock : public LazyDock {
    Q_OBJECT

public:
    explicit LoopTestsDock(Requests& requests, QWidget* parent = nullptr);

    // As in its pages.
    void showModule(const PanelView& view);
    void showNothing();
    /// For another connection: discards what was measured.
    void forgetModules();
    [[nodiscard]] SquareWavePage& squareWave();
    [[nodiscard]] FrequencyPage& frequency();

signals:
    /// A report on everything that is known of the selected module's loop is requested.
    void reportWanted();

private:
    void build() override;

    void showReportPossible(bool servo);

    Requests& m_requests;
    QTabWidget* m_tabs = nullptr;
    QPushButton* m_report = nullptr;
    SquareWavePage* m_square = nullptr;
    FrequencyPage* m_frequency = nullptr;
};

}  // namespace nmc
