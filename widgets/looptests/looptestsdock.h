// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/filedialog.h"
#include "widgets/common/lazydock.h"
#include "widgets/panels/panelview.h"

class QPushButton;
class QTabWidget;

namespace nmc {

class FrequencyPage;
struct KeptResponse;
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
    /// For another connection: discards the frequency responses.
    void forgetModules();
    [[nodiscard]] SquareWavePage& squareWave();
    [[nodiscard]] FrequencyPage& frequency();

signals:
    void runKept(const nmc::KeptResponse& run);
    /// A report on everything that is known of the selected module's loop is requested.
    void reportWanted();
    /// The frequency response of the selected module, measured at `measured`, is to be saved.
    void frequenciesWanted(const QString& path, const QDateTime& measured);

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
