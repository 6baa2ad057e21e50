// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMargins>
#include <optional>

#include "widgets/scope/plotcanvas.h"

namespace nmc {

/// A plot of a finished record, fitted to it until the user zooms or moves it, with the mouse or with the
/// keys of the scope. GUI thread.
class RecordPlot : public PlotCanvas {
    Q_OBJECT

public:
    /// `wanted` and `least`: its sizes, in lines of text.
    RecordPlot(const QSize& wanted, const QSize& least, QWidget* parent);

    /// Shows what is visible at first again.
    virtual void fitAgain();
    [[nodiscard]] const PlotGeometry& geometryShown() const { return m_geometry; }
    [[nodiscard]] QSize sizeHint() const override { return m_wanted * fontMetrics().height(); }
    [[nodiscard]] QSize minimumSizeHint() const override { return m_least * fontMetrics().height(); }

protected:
    /// A visible range of time, in s, and of values, in the unit of the axis.
    struct View {
        double left, right, bottom, top;
    };

    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void zoomTime(double factor, double at) override;
    void zoomValues(double factor, double at) override;
    void pan(double timeShare, double valueShare) override;
    void showTime(double left, double right) override;
    void showEverything() override { fitAgain(); }
    void moveCursor(std::size_t cursor, double seconds) override;
    /// Names the only curve, unless the derived plot has others.
    void refreshLegend() override;

    [[nodiscard]] virtual View fitted() const = 0;
    /// Room in pixels around the plot area, beside that for the numbers of the value axis; at first only for
    /// the numbers of the other axis.
    [[nodiscard]] virtual QMargins room() const;
    /// Height of the plot with its axes, in pixels.
    [[nodiscard]] virtual int frameHeight() const { return height(); }
    [[nodiscard]] View seen() const;
    /// Sets the axes to what is to be visible. To be called when the record has changed.
    void fit();

    QString m_label;  ///< of the only curve, with its unit; empty while there is none

private:
    void showView(const View& view);

    QSize m_wanted, m_least;
    std::optional<View> m_view;  ///< as chosen by the user
};

}  // namespace nmc
