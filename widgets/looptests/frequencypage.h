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
class TestForm;

/// How the loop of the selected servo follows sines of its command. The last response of each module stays
/// until the next.
class FrequencyPage : public QWidget {
    Q_OBJECT

public:
    explicit FrequencyPage(QWidget* parent = nullptr);

    // Emit nothing.
    void showModule(const PanelView& view);
    void showNothing();
    void forgetModules();
    /// Those that are measured, from the first one on.
    void showReport(const ProcedureReport& report);

    /// Of the module that is shown; empty before there is one.
    [[nodiscard]] const std::vector<FrequencyPoint>& points() const;

signals:
    void asked(nmc::ModuleIndex module, const nmc::Intent& intent);
    /// points(), which were measured then.
    void saveWanted(const QString& path, const QDateTime& measured);

private:
    void refresh();
    void chooseFile();

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
