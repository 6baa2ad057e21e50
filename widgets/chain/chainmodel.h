// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractListModel>
#include <map>
#include <vector>

#include "model/module/linkstate.h"
#include "model/procedure/procedure.h"
#include "model/settings/axisscale.h"
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
        Title,     ///< "X axis", or "Module 1" if it has no name
        TypeText,  ///< "PIC-SERVO v4"
        ActivityValue,
        ActivityText,  ///< "Holding · 92/s", with the status replies per second; or the stage of a procedure
        Position,     ///< "12 345", "1.250 mm", "◇ 1.250 mm" from a work offset, or a dash; empty without a
                      ///< motor
        HomeIsKnown,  ///< and the position does not count from a work offset
        PositionIsOld  ///< the position is out of date or doubtful
    };

    using Procedures = std::map<ModuleIndex, ProcedureReport>;  ///< the last one of each module

    using QAbstractListModel::QAbstractListModel;

    void showLink(const LinkState& state, const Machine& machine, const Procedures& procedures);
    [[nodiscard]] int moduleCount() const { return static_cast<int>(m_rows.size()); }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

private:
    /// What the words of a row are made from; they are made again when it changes.
    struct Facts {
        QString name;
        std::string axis;
        ModuleIdentity identity;
        int address = 0;
        int rate = 0;  ///< status replies per second
        Activity activity = Activity::Unknown;
        QString word;  ///< the activity in words
        bool lookedFor = false;
        bool motor = false;                        ///< it has a motor, with a position and a home
        std::optional<ProcedureReport> procedure;  ///< while it runs
        AxisScale scale;
        std::optional<HomeFact::Place> home;
        std::optional<WorkZero> zero;
        bool operator==(const Facts&) const = default;
    };
    struct Row {
        Facts facts;
        std::optional<std::int32_t> counts;
        bool old = false;
        bool doubtful = false;  ///< the position may be another module's
        TimePoint seen;
        // The words:
        QString title;
        QString type;
        QString activity;
        QString position;
        QString unit;
    };
    [[nodiscard]] static Facts factsOf(const ModuleState& module, const Machine& machine,
                                       const Procedures& procedures);
    /// Updates the row. Returns true if anything in it has changed.
    static bool show(Row& row, Facts facts, const LinkState& link, const ModuleState& module);
    [[nodiscard]] QString spoken(const Row& row) const;

    std::vector<Row> m_rows;
    std::optional<TimePoint> m_now;
    QString m_host;
    bool m_open = false;
};

}  // namespace nmc
