// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QWidget>
#include <map>
#include <vector>

#include "widgets/common/filedialog.h"
#include "widgets/panels/panelview.h"

class QLabel;
class QPushButton;

namespace nmc {

class BodePlot;
class NumberField;
class QuantityField;
class Requests;
class TestForm;

/// The frequency response of the selected servo: how its loop follows sines of the command. The last response
/// of each module is kept until the next.
class FrequencyPage : public QWidget {
    Q_OBJECT

public:
    explicit FrequencyPage(Requests& requests, QWidget* parent = nullptr);

    // These emit nothing.
    void showModule(const PanelView& view);
    void showNothing();
    void forgetModules();
    /// Shows the points measured so far, from the first one on.
    void showReport(const ProcedureReport& report);

    /// The points of the module that is shown; empty while there are none.
    [[nodiscard]] const std::vector<FrequencyPoint>& points() const;

private:
    void refresh();
    void chooseFile();

    Requests& m_requests;
    TestForm* m_form;
    QuantityField* m_amplitude;
    NumberField* m_from;
    NumberField* m_to;
    BodePlot* m_plot;
    QLabel* m_figures;
    QPushButton* m_save;
    struct Found {
        std::vector<FrequencyPoint> points;
        bool endedEarly = false;
        QDateTime measured{};
    };
    std::map<ModuleIndex, Found> m_found;
    std::optional<ModuleIndex> m_shown;
};

}  // namespace nmc
