// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "widgets/scope/scopeplot.h"
#include "widgets/scope/scopewords.h"

namespace nmc {

/// The status bits of one module over time, drawn as a logic analyser does: high, low, and a bar where a bit
/// changed within one pixel. Shares the strips' time axis.
class StatusLane : public QWidget {
    Q_OBJECT

public:
    explicit StatusLane(QWidget* parent = nullptr);

    void setBits(const ScopeModule& module, std::vector<ScopeBit> bits);
    [[nodiscard]] const std::vector<ScopeBit>& bits() const { return m_bits; }
    /// `history` is null if there is nothing to show.
    void showFrame(const ScopePlot::View& view, const ModuleHistory* history);
    void showCursors(const std::optional<CursorTimes>& cursors);

    /// Width that the names to the left of the bits need.
    [[nodiscard]] int labelWidth() const;
    /// Left and right end of the strips' plot area, in this widget's coordinates.
    void setArea(double left, double right);
    void renderTo(QPainter& painter);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Piece {
        double left, right;  ///< s
        unsigned all, any;   ///< status in the low byte
        bool joined;
    };
    [[nodiscard]] QFont ownFont() const;
    [[nodiscard]] QFontMetrics ownMetrics() const;
    [[nodiscard]] int rowHeight() const;
    void paintBit(QPainter& painter, const ScopeBit& bit, const QRectF& row) const;

    ModuleType m_type = ModuleType::Servo;
    std::vector<ScopeBit> m_bits;
    QStringList m_names;
    std::vector<Piece> m_pieces;
    PlotGeometry m_geometry;
    std::optional<CursorTimes> m_cursors;
};

}  // namespace nmc
