// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/packetview.h"

#include <QFontDatabase>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>
#include <QScrollBar>
#include <algorithm>

#include "widgets/common/look.h"
#include "widgets/monitor/packetmodel.h"

namespace nmc {

using namespace Qt::StringLiterals;

PacketView::PacketView(PacketModel& model, QWidget* parent) : QTableView(parent), m_model(model) {
    look::name(this, u"packetTable"_s, tr("Packets, newest last"));
    setModel(&m_model);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setTabKeyNavigation(false);
    setWordWrap(false);
    setShowGrid(false);
    setFrameShape(QFrame::NoFrame);
    setVerticalScrollMode(QAbstractItemView::ScrollPerItem);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    verticalHeader()->hide();
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setStretchLastSection(true);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setSectionsMovable(true);
    fitRows();
    fitColumns();
}

void PacketView::fitRows() {
    const QFontMetrics fixed(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    verticalHeader()->setMinimumSectionSize(1);
    verticalHeader()->setDefaultSectionSize(qMax(fixed.height(), fontMetrics().height()) +
                                            look::gridUnit(this) / 3);
}

void PacketView::fitColumns() {
    const QFontMetrics fixed(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    const int digit = fixed.horizontalAdvance(u'0');
    const int letter = fontMetrics().averageCharWidth();
    const int room = look::gridUnit(this);
    setColumnWidth(PacketModel::Time, digit * 13 + room);
    setColumnWidth(PacketModel::Target, letter * 12 + room);
    setColumnWidth(PacketModel::Purpose, letter * 12 + room);
    setColumnWidth(PacketModel::Command, digit * 20 + room);
    setColumnWidth(PacketModel::Meaning, letter * 30 + room);
    setColumnWidth(PacketModel::Reply, digit * 28 + room);
    setColumnWidth(PacketModel::ReplyMeaning, letter * 50 + room);
    setColumnWidth(PacketModel::Verdict, letter * 24 + room);
}

void PacketView::append(std::vector<bus::ExchangeRecord> records) {
    QScrollBar* bar = verticalScrollBar();
    const int top = bar->value();
    const bool following = top >= bar->maximum();
    const int dropped = m_model.append(std::move(records));
    if (following)
        scrollToBottom();
    else if (dropped > 0)
        bar->setValue(top - dropped);  // the rows being read stay where they are
}

QString PacketView::selectedText() const {
    QStringList lines;
    QList<int> rows;
    for (const QModelIndex& index : selectionModel()->selectedRows())
        rows << index.row();
    if (rows.isEmpty())
        for (int row = 0; row < m_model.rowCount(); ++row)
            rows << row;
    std::sort(rows.begin(), rows.end());
    for (const int row : rows)
        lines << m_model.line(row);
    return lines.join(u'\n');
}

void PacketView::keyPressEvent(QKeyEvent* event) {
    // The table itself would copy one cell only.
    if (event->matches(QKeySequence::Copy)) {
        emit copyRequested();
        event->accept();
        return;
    }
    QTableView::keyPressEvent(event);
}

void PacketView::changeEvent(QEvent* event) {
    QTableView::changeEvent(event);
    if (event->type() == QEvent::FontChange)
        fitRows();
}

void PacketView::paintEvent(QPaintEvent* event) {
    QTableView::paintEvent(event);
    if (m_model.rowCount() > 0)
        return;
    QPainter painter(viewport());
    painter.setPen(look::mutedText(palette()));
    const int margin = look::gridUnit(this);
    painter.drawText(viewport()->rect().adjusted(margin, margin, -margin, -margin),
                     Qt::AlignTop | Qt::AlignLeft | Qt::TextWordWrap,
                     m_model.log().empty()
                         ? tr("No packets. Exchanges are recorded while this view is visible.")
                         : tr("No packets match the filter."));
}

}  // namespace nmc
