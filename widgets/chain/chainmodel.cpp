// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chain/chainmodel.h"

#include <cmath>

#include "model/module/modulescale.h"
#include "widgets/common/homewords.h"
#include "widgets/common/texts.h"
#include "widgets/common/unitwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

ChainModel::Row ChainModel::rowOf(const LinkState& link, const ModuleState& module,
                                  const AxisSettings& settings) {
    Row row;
    row.address = module.info.address.value();
    row.name = texts::moduleName(module.info.index);
    row.title = settings.name.empty() ? row.name : QString::fromStdString(settings.name);
    row.type = texts::moduleType(module.info.identity);
    if (module.repliesPerSecond > 0.0)
        row.rate = tr("%1/s").arg(texts::readout(std::round(module.repliesPerSecond)));
    row.activity = module.activity();
    const AxisScale scale = scaleOf(module, settings);
    row.position = u"–"_s;
    row.unit = texts::unitOf(scale);
    if (module.latest.has_value() && module.latest->position.has_value())
        row.position = texts::fixedPosition(scale, *module.latest->position);
    row.homeIsKnown = module.home.place().has_value();
    row.home = texts::home(module.home, scale);
    row.homeMeaning = texts::homeMeaning(module, scale);
    row.native = scale.native();
    row.old = !isLive(link, module);
    return row;
}

void ChainModel::showLink(const LinkState& state, const Machine& machine) {
    const bool open = state.phase != LinkPhase::Disconnected;
    const std::size_t count = open ? state.modules.size() : 0;
    if (open != m_open || count != m_rows.size()) {
        beginResetModel();
        m_open = open;
        m_rows.clear();
        for (std::size_t i = 0; i < count; ++i)
            m_rows.push_back(rowOf(state, state.modules[i], machine.axis(state.modules[i].info.index)));
        m_host = texts::portName(QString::fromStdString(state.port));
        endResetModel();
        return;
    }
    for (std::size_t i = 0; i < count; ++i) {
        Row row = rowOf(state, state.modules[i], machine.axis(state.modules[i].info.index));
        if (row == m_rows[i])
            continue;
        m_rows[i] = std::move(row);
        const QModelIndex changed = index(static_cast<int>(i));
        emit dataChanged(changed, changed);
    }
    const QString host = texts::portName(QString::fromStdString(state.port));
    if (host != m_host) {
        m_host = host;
        if (!m_open)
            return;  // there is no row of it
        const QModelIndex changed = index(moduleCount());
        emit dataChanged(changed, changed);
    }
}

int ChainModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !m_open ? 0 : moduleCount() + 1;
}

QVariant ChainModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() > moduleCount())
        return {};
    if (index.row() == moduleCount()) {
        if (role == IsHost)
            return true;
        if (role == Qt::DisplayRole || role == Name || role == Qt::AccessibleTextRole)
            return tr("PC");
        if (role == TypeText)
            return m_host;
        return {};
    }
    const Row& row = m_rows[static_cast<std::size_t>(index.row())];
    switch (role) {
        case Qt::DisplayRole:
        case Name:
            return row.name;
        case Title:
            return row.title;
        case IsHost:
            return false;
        case Address:
            return row.address;
        case TypeText:
            return row.type;
        case ActivityValue:
            return static_cast<int>(row.activity);
        case ActivityText:
            return row.rate.isEmpty() ? texts::activity(row.activity)
                                      : tr("%1 · %2").arg(texts::activity(row.activity), row.rate);
        case Position:
            return row.native ? row.position : row.position + u' ' + row.unit;
        case HomeIsKnown:
            return row.homeIsKnown;
        case PositionIsOld:
            return row.old;
        case Qt::AccessibleTextRole:
            return tr("%1, address %2, %3, %4, position %5 %6")
                       .arg(row.name)
                       .arg(row.address)
                       .arg(row.type, texts::activity(row.activity), row.position, row.unit) +
                   u". "_s + row.home;
        case Qt::ToolTipRole:
            return tr("%1 at address %2 on the wire. %3")
                       .arg(row.name)
                       .arg(row.address)
                       .arg(texts::activityMeaning(row.activity)) +
                   u'\n' + row.homeMeaning;
        default:
            return {};
    }
}

Qt::ItemFlags ChainModel::flags(const QModelIndex& index) const {
    if (!index.isValid())
        return Qt::NoItemFlags;
    if (index.row() >= moduleCount())
        return Qt::ItemNeverHasChildren;
    return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
}

}  // namespace nmc
