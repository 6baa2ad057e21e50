// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <map>
#include <optional>
#include <vector>

#include "model/response/responsefile.h"
#include "widgets/panels/panelview.h"

class QLabel;
class QPushButton;

namespace nmc {

class Requests;
class SquarePlot;
class TestForm;

/// A square wave of the command position of the selected servo: overlays many edges while the gains are
/// changed. Waves of several servos may run at the same time; the edges of the last one of each are kept.
class SquareWavePage : public QWidget {
    Q_OBJECT

public:
    explicit SquareWavePage(Requests& requests, QWidget* parent = nullptr);

    // These emit nothing.
    void showModule(const PanelView& view);
    /// What was shown last stays.
    void showNothing();
    void forgetModules();
    /// A wave of the module begins: discards the edges of its previous one.
    void clear(ModuleIndex module);
    void showEdge(KeptResponse edge);

private:
    struct Wave {
        std::vector<ResponseRecord> edges;
        KeptResponse labels;  ///< origin of the edges
    };
    void refresh();
    void keep();
    /// That of the module that is shown; null if there is none.
    [[nodiscard]] const Wave* shown() const;

    Requests& m_requests;
    TestForm* m_form;
    SquarePlot* m_plot;
    QLabel* m_results;
    QPushButton* m_keep;
    std::map<ModuleIndex, Wave> m_waves;
    std::optional<ModuleIndex> m_shown;
    std::optional<ResponseRecord> m_folded;  ///< median of the rising edges with the present gains
};

}  // namespace nmc
