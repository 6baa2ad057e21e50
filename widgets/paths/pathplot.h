// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPixmap>
#include <QWidget>
#include <vector>

#include "model/path/pathfile.h"

namespace nmc {

/// Plots the positions of a path over time, with a lane for each axis, and its progress. Once drawn, the cost
/// of redrawing does not depend on the number of points.
class PathPlot : public QWidget {
    Q_OBJECT

public:
    explicit PathPlot(QWidget* parent = nullptr);

    /// `axes`: those of the table's columns.
    void showPath(const PathTable& table, const std::vector<PathColumn>& axes);
    void showNothing();
    /// `share`: 0 to 1; below 0 if the path is not running.
    void showProgress(double share);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct Lane {
        QString title;  ///< name and unit
        QString lowest, highest;
        std::vector<double> points;
        double bottom = 0.0, top = 1.0;
    };
    void forgetPicture();
    [[nodiscard]] QRectF area(std::size_t lane) const;
    void paintLane(QPainter& painter, const Lane& lane, const QRectF& area, const QColor& colour) const;
    void drawPicture();

    std::vector<Lane> m_lanes;
    double m_share = -1.0;
    QPixmap m_picture;
};

}  // namespace nmc
