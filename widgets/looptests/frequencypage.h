// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QWidget>
#include <map>
#include <vector>

#include "widgets/common/filedialog.h"
#include "widgets/looptests/bodeplot.h"
#include "widgets/panels/panelview.h"

class QLabel;
class QPushButton;

namespace nmc {

class Requests;
class TestForm;

/// The frequency response of the selected servo: how its loop follows sines of the command, and how it would
/// with the gains in the fields. The last response of each module is kept until the next; of those at rest
/// and in motion, both are, as long as the gains are the same. One that ended early leaves one of
/// the same gains with at least as many frequencies in its place.
class FrequencyPage : public QWidget {
    Q_OBJECT

public:
    explicit FrequencyPage(Requests& requests, QWidget* parent = nullptr);

    // These emit nothing.
    void showModule(const PanelView& view);
    void showNothing();
    void forgetModules();
    /// Shows the points measured so far, from the first one on.
    void showReport(const ProcedureReport& report, const QString& port, bool simulated);

    struct Found {
        ProcedureReport report;
        QDateTime measured;
        QString port;
        bool simulated = false;
    };
    /// The last response of the module that is shown; null while there is none.
    [[nodiscard]] const Found* last() const;

private:
    struct Responses {
        std::vector<Found> shown;   ///< the last one last
        std::vector<Found> before;  ///< shown before the last measurement
        bool discarded = false;     ///< the last measurement, which ended early
    };
    void refresh();
    /// Returns the curves to draw, and shows in words what the gains in the fields would do.
    [[nodiscard]] std::vector<BodePlot::Curve> curves();
    void chooseFile();

    Requests& m_requests;
    TestForm* m_form;
    BodePlot* m_plot;
    QLabel* m_figures;
    QLabel* m_would;
    QPushButton* m_save;
    std::map<ModuleIndex, Responses> m_found;
    std::optional<servo::SetGain> m_staged;  ///< in the fields of the module that is shown
    std::optional<ModuleIndex> m_shown;
};

}  // namespace nmc
