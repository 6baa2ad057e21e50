// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "model/sequence/sequence.h"
#include "widgets/common/sequencetexts.h"

namespace nmc {

/// The points of a machine: their names, which can be edited, and the positions of their axes.
class PointsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Name, Places, ColumnCount };
    using QAbstractTableModel::QAbstractTableModel;

    void showPoints(const std::vector<Point>& points, const texts::ScaleOfAxis& scale);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

signals:
    /// The user has entered another name, which is neither empty nor taken.
    void renameWanted(const std::string& from, const std::string& to);

private:
    template <typename Model, typename Row>
    friend void changeRowCount(Model& model, std::vector<Row>& rows, const std::vector<Row>& now);
    std::vector<Point> m_points;
    std::vector<QString> m_places;
};

}  // namespace nmc
