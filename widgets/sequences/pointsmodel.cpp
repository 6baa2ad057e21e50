// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sequences/pointsmodel.h"

#include "widgets/sequences/tablerows.h"

namespace nmc {

void PointsModel::showPoints(const std::vector<Point>& points, const texts::ScaleOfAxis& scale) {
    std::vector<QString> places;
    for (const Point& point : points)
        places.push_back(texts::placesOf(point, scale));
    if (points == m_points && places == m_places)
        return;
    changeRowCount(*this, m_points, points);
    m_points = points;
    m_places = std::move(places);
    if (!m_points.empty())
        emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

int PointsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_points.size());
}

int PointsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant PointsModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const auto row = static_cast<std::size_t>(index.row());
    const QString text = index.column() == Name  ? QString::fromStdString(m_points[row].name)
                         : row < m_places.size() ? m_places[row]
                                                 : QString();
    if (role == Qt::DisplayRole || role == Qt::ToolTipRole ||
        (role == Qt::EditRole && index.column() == Name))
        return text;
    return {};
}

QVariant PointsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role != Qt::DisplayRole || orientation != Qt::Horizontal)
        return {};
    return section == Name ? tr("Point") : tr("Positions");
}

Qt::ItemFlags PointsModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    return index.isValid() && index.column() == Name ? flags | Qt::ItemIsEditable : flags;
}

bool PointsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    const std::string name = value.toString().simplified().toStdString();
    const bool taken = std::ranges::find(m_points, name, &Point::name) != m_points.end();
    if (!index.isValid() || index.column() != Name || role != Qt::EditRole || name.empty() || taken)
        return false;
    const std::string before = m_points[static_cast<std::size_t>(index.row())].name;
    emit renameWanted(before, name);
    return true;
}

}  // namespace nmc
