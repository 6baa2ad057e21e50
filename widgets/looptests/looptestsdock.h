// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/filedialog.h"
#include "widgets/common/lazydock.h"
#include "widgets/panels/panelview.h"

class QPushButton;
class QTabWidget;

namespace nmc {

class FrequencyPage;
class SquareWavePage;
struct KeptResponse;

/// The place of the longer tests of a loop, closed at first: its content is built when it is seen for the
/// first time, or when a test tells of itself.
class LoopTestsDock : public LazyDock {
    Q_OBJECT

public:
    explicit LoopTestsDock(QWidget* parent = nullptr);

    // As in its pages.
    void showModule(const PanelView& view);
    void showNothing();
    /// Those that come are of another connection.
    void forgetModules();
    [[nodiscard]] SquareWavePage& squareWave();
    [[nodiscard]] FrequencyPage& frequency();

signals:
    void asked(nmc::ModuleIndex module, const nmc::Intent& intent);
    void runKept(const nmc::KeptResponse& run);
    /// Of all that is known of the selected module's loop.
    void reportWanted();
    /// The selected module's frequency response, which was measured then.
    void frequenciesWanted(const QString& path, const QDateTime& measured);

private:
    void build() override;

    void showReportPossible(bool servo);

    QTabWidget* m_tabs = nullptr;
    QPushButton* m_report = nullptr;
    SquareWavePage* m_square = nullptr;
    FrequencyPage* m_frequency = nullptr;
};

}  // namespace nmc
