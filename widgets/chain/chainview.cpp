// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chain/chainview.h"

#include <QPainter>
#include <QScopedValueRollback>

#include "widgets/chain/chaindelegate.h"
#include "widgets/chain/chainmodel.h"
#include "widgets/common/look.h"

namespace nmc {

using namespace Qt::StringLiterals;

ChainView::ChainView(QWidget* parent) : QListView(parent), m_model(new ChainModel(this)) {
    look::name(this, u"chainList"_s, tr("Modules in wire order, the farthest from the PC first"));
    setModel(m_model);
    setItemDelegate(new ChainDelegate(this));
    setSelectionMode(QAbstractItemView::SingleSelection);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFrameShape(QFrame::NoFrame);
    setUniformItemSizes(false);
    setMinimumWidth(fontMetrics().height() * 14);
}

void ChainView::showLink(const LinkState& state, const Machine& machine,
                         const std::map<ModuleIndex, ProcedureReport>& procedures) {
    const QScopedValueRollback<bool> showing(m_showing, true);
    m_model->showLink(state, machine, procedures);
}

void ChainView::showSelected(ModuleIndex module) {
    const QScopedValueRollback<bool> showing(m_showing, true);
    if (currentIndex().row() != module.value())
        setCurrentIndex(m_model->index(module.value()));
}

QSize ChainView::sizeHint() const {
    return {fontMetrics().height() * 16, fontMetrics().height() * 24};
}

void ChainView::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
    QListView::currentChanged(current, previous);
    if (current.isValid() && current.row() < m_model->moduleCount() && !m_showing)
        emit moduleSelected(ModuleIndex(static_cast<std::uint8_t>(current.row())));
}

/// QListView would place all rows again after each change of one, although their heights never change.
void ChainView::dataChanged(const QModelIndex& topLeft, const QModelIndex& bottomRight,
                            const QList<int>& roles) {
    QAbstractItemView::dataChanged(topLeft, bottomRight, roles);
}

void ChainView::paintEvent(QPaintEvent* event) {
    QListView::paintEvent(event);
    if (m_model->rowCount() > 0)
        return;
    QPainter painter(viewport());
    painter.setPen(look::mutedText(palette()));
    const int unit = look::gridUnit(this);
    painter.drawText(
        viewport()->rect().adjusted(unit * 2, unit * 2, -unit * 2, -unit * 2),
        Qt::TextWordWrap | Qt::AlignLeft | Qt::AlignTop,
        tr("Not connected.\n\nChoose a port above and connect. Without hardware, choose the simulator."));
}

}  // namespace nmc
