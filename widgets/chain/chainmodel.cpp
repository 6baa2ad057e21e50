// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chain/chainmodel.h"

#include "model/module/modulescale.h"
#include "widgets/common/homewords.h"
#include "widgets/common/positiontexts.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/texts.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/workwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

ChainModel::Facts ChainModel::factsOf(const ModuleState& module, const Machine& machine,
                                      const Procedures& procedures) {
    const AxisSettings& settings = machine.axis(module.info.index);
    Facts facts;
    facts.name = texts::moduleName(module.info.index);
    facts.axis = settings.name;
    facts.identity = module.info.identity;
    facts.address = module.info.address.value();
    facts.lookedFor = module.lookedFor;
    facts.rate = facts.lookedFor ? 0 : qRound(module.repliesPerSecond);
    facts.activity = module.activity();
    if (const auto run = procedures.find(module.info.index); run != procedures.end() && !run->second.over())
        facts.procedure = run->second;
    facts.motor = module.isServo() || module.isStepper();
    facts.scale = scaleOf(module, settings);
    facts.word = texts::activity(module, facts.scale);
    facts.home = module.home.place();
    facts.zero = module.home.workZero();
    return facts;
}

bool ChainModel::show(Row& row, Facts facts, const LinkState& link, const ModuleState& module) {
    const bool first = row.type.isEmpty();
    const bool others = first || !(facts == row.facts);
    const auto counts = module.latest ? module.latest->position : std::nullopt;
    const bool old = !isLive(link, module);
    const bool moved = others || counts != row.counts;
    const bool news = moved || old != row.old || module.positionDoubtful() != row.doubtful;
    row.seen = module.latestTime;
    row.old = old;
    row.doubtful = module.positionDoubtful();
    if (others) {
        row.facts = std::move(facts);
        row.title = row.facts.axis.empty() ? row.facts.name : QString::fromStdString(row.facts.axis);
        row.type = texts::moduleType(row.facts.identity);
        row.activity = row.facts.procedure ? texts::procedureStage(*row.facts.procedure) : row.facts.word;
        if (row.facts.lookedFor)
            row.activity = tr("%1 · looking for modules…").arg(row.activity);
        row.unit = texts::unitOf(row.facts.scale);
    }
    if (moved) {
        row.counts = counts;
        row.position = counts ? texts::marked(row.facts.zero, row.facts.scale, *counts) : u"–"_s;
    }
    return news;
}

void ChainModel::showLink(const LinkState& state, const Machine& machine, const Procedures& procedures) {
    const bool open = state.hasChain();
    m_now = state.now;
    const std::size_t count = open ? state.modules.size() : 0;
    const bool others = open != m_open || count != m_rows.size();
    if (others) {
        beginResetModel();
        m_open = open;
        m_rows.assign(count, {});
    }
    for (std::size_t i = 0; i < count; ++i) {
        const ModuleState& module = state.modules[i];
        if (!show(m_rows[i], factsOf(module, machine, procedures), state, module) || others)
            continue;
        const QModelIndex changed = index(static_cast<int>(i));
        emit dataChanged(changed, changed);
    }
    const QString host = texts::portName(QString::fromStdString(state.port));
    const bool otherHost = host != m_host;
    m_host = host;
    if (others) {
        endResetModel();
    } else if (otherHost && open) {  // otherwise it has no row
        const QModelIndex changed = index(moduleCount());
        emit dataChanged(changed, changed);
    }
}

/// The row as it is read out: what it shows, and what a struck-out position means.
QString ChainModel::spoken(const Row& row) const {
    const QString who = tr("%1, address %2, %3, %4")
                            .arg(row.facts.name, QString::number(row.facts.address), row.type, row.activity);
    if (!row.facts.motor)
        return who;
    QString where = row.counts ? row.position + u' ' + row.unit : tr("unknown");
    if (row.counts && row.old)
        where += u", "_s + texts::age(m_now ? toSeconds(*m_now - row.seen) : 0, row.doubtful);
    return tr("%1, position %2").arg(who, where) + u". "_s + texts::zeroInUse(row.facts.zero) +
           (row.facts.zero ? u" "_s : QString()) +
           texts::home(row.facts.home, row.facts.zero, row.facts.scale);
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
        if (role == TypeText || role == Qt::ToolTipRole)
            return m_host;
        return {};
    }
    const Row& row = m_rows[static_cast<std::size_t>(index.row())];
    switch (role) {
        case Qt::DisplayRole:
        case Name:
            return row.facts.name;
        case Title:
            return row.title;
        case IsHost:
            return false;
        case Address:
            return row.facts.address;
        case TypeText:
            return row.type;
        case ActivityValue:
            return static_cast<int>(row.facts.activity);
        case ActivityText:
            return row.facts.rate == 0
                       ? row.activity
                       : tr("%1 · %2").arg(row.activity,
                                           Common::tr("%1/s").arg(texts::readout(row.facts.rate)));
        case Position:
            return !row.facts.motor           ? QString()
                   : row.facts.scale.native() ? row.position
                                              : row.position + u' ' + row.unit;
        case HomeIsKnown:
            return row.facts.home && row.facts.home->verified() && !row.facts.zero;
        case PositionIsOld:
            return row.old;
        case Qt::AccessibleTextRole:
            return spoken(row);
        case Qt::ToolTipRole:
            // In full, since there may be no room for all of it in the list.
            return tr("%1, %2, at address %3 on the wire")
                       .arg(row.facts.name, row.type, QString::number(row.facts.address)) +
                   u'\n' + row.activity + u": "_s +
                   texts::activityMeaning(row.facts.activity, row.facts.identity.type) +
                   (row.facts.motor ? u'\n' + texts::homeMeaning(row.facts.home, row.facts.zero, row.seen,
                                                                 row.facts.scale)
                                    : QString()) +
                   (row.facts.zero ? u'\n' + texts::zeroInUse(row.facts.zero) : QString());
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
