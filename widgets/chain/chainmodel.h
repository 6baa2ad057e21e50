// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractListModel>
#include <vector>

#include "model/module/linkstate.h"
#include "model/settings/machine.h"

namespace nmc {

/// The modules in wire order, the one farthest from the host first, and the host itself as the last row.
class ChainModel : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role {
        IsHost = Qt::UserRole,
        Address,   ///< int
        Name,      ///< "Module 1 "X axis""
        Title,     ///< "X axis"; "Module 1" without a name: its number stands on the wire
        TypeText,  ///< "PIC-SERVO v4"
        ActivityValue,
        ActivityText,  ///< "Holding · 92/s", with the status replies per second
        Position,      ///< "12 345", "1.250 mm", or a dash
        HomeIsKnown,
        PositionIsOld  ///< the module does not answer
    };

    using QAbstractListModel::QAbstractListModel;

    void showLink(const LinkState& state, const Machine& machine);
    [[nodiscard]] int moduleCount() const { return static_cast<int>(m_rows.size()); }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

private:
    struct Row {
        int address = 0;
        QString name;
        QString title;
        QString type;
        QString rate;
        Activity activity = Activity::Unknown;
        QString position;
        QString unit;
        bool homeIsKnown = false;
        QString home;
        QString homeMeaning;
        bool native = true;
        bool old = false;
        bool operator==(const Row&) const = default;
    };
    [[nodiscard]] static Row rowOf(const LinkState& link, const ModuleState& module,
                                   const AxisSettings& settings);

    std::vector<Row> m_rows;
    QString m_host;
    bool m_open = false;
};

}  // namespace nmc
