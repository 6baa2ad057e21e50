// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "model/response/responsefile.h"
#include "widgets/panels/panelview.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace nmc {

class NumberField;
class QuantityField;
class Requests;
class SquarePlot;
class TestForm;

/// A square wave of the command position of the selected servo: overlays many edges while the gains are
/// changed.
class SquareWavePage : public QWidget {
    Q_OBJECT

public:
    explicit SquareWavePage(Requests& requests, QWidget* parent = nullptr);

    // These emit nothing.
    void showModule(const PanelView& view);
    void showNothing();
    /// A wave begins, or another connection: discards the edges of the previous one.
    void clear();
    void showEdge(KeptResponse edge);

private:
    void refresh();
    void keep();

    Requests& m_requests;
    TestForm* m_form;
    QuantityField* m_counts;
    NumberField* m_period;
    NumberField* m_rounds;
    QuantityField* m_excursion;
    QComboBox* m_method;
    SquarePlot* m_plot;
    QLabel* m_results;
    QPushButton* m_keep;
    std::vector<ResponseRecord> m_edges;
    std::optional<ResponseRecord> m_folded;  ///< median of the rising edges with the present gains
    KeptResponse m_labels;                   ///< origin of the edges
};

}  // namespace nmc
