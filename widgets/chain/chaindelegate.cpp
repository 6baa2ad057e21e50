// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chain/chaindelegate.h"

#include <QApplication>
#include <QPainter>

#include "widgets/chain/chainmodel.h"
#include "widgets/common/glyphs.h"
#include "widgets/common/look.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
int unitOf(const QStyleOptionViewItem& option) {
    return qMax(4, option.fontMetrics.height() / 2);
}
}  // namespace

void ChainDelegate::paintWire(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index,
                              const QRect& column) {
    const bool host = index.data(ChainModel::IsHost).toBool();
    const double pen = qMax(1.5, option.fontMetrics.height() / 9.0);
    painter->setPen(QPen(look::mutedText(option.palette), pen));
    const int x = column.center().x();
    const int top = index.row() == 0 ? column.center().y() : column.top();
    const int bottom = host ? column.center().y() : column.bottom() + 1;
    painter->drawLine(x, top, x, bottom);

    const QString text = host ? index.data(ChainModel::Name).toString()
                              : QString::number(index.data(ChainModel::Address).toInt());
    QFont font = option.font;
    font.setBold(true);
    painter->setFont(font);
    const int height = option.fontMetrics.height() + unitOf(option) / 2;
    const int width = qMax(height, QFontMetrics(font).horizontalAdvance(text) + unitOf(option));
    const QRectF node(x - width / 2.0 + 0.5, column.center().y() - height / 2.0 + 0.5, width, height);
    painter->setBrush(option.palette.color(QPalette::Base));
    const double radius = host ? height / 6.0 : height / 2.0;
    painter->drawRoundedRect(node, radius, radius);
    painter->setPen(option.palette.color(QPalette::Active, QPalette::Text));
    painter->drawText(node, Qt::AlignCenter, text);
}

void ChainDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const QPalette& palette = option.palette;
    const int unit = unitOf(option);
    const QRect r = option.rect;
    const bool selected = option.state.testFlag(QStyle::State_Selected);
    if (selected) {
        // A tint and a bar, not the full highlight: the states keep their colours and their contrast.
        QColor tint = palette.color(QPalette::Active, QPalette::Highlight);
        tint.setAlphaF(look::isDark(palette) ? 0.30F : 0.16F);
        painter->fillRect(r, tint);
        painter->fillRect(QRect(r.left(), r.top(), qMax(3, unit / 2), r.height()),
                          palette.color(QPalette::Active, QPalette::Highlight));
    }
    const int wireWidth = option.fontMetrics.height() * 5 / 2;
    paintWire(painter, option, index, QRect(r.left() + unit / 2, r.top(), wireWidth, r.height()));

    const QColor text = palette.color(QPalette::Active, QPalette::Text);
    const QColor muted = look::mutedText(palette);
    const int line = option.fontMetrics.height() * 5 / 4;
    QRect body(r.left() + unit / 2 + wireWidth + unit, r.center().y() - line, 0, line);
    body.setRight(r.right() - unit);
    QFont bold = option.font;
    bold.setBold(true);

    if (index.data(ChainModel::IsHost).toBool()) {
        painter->setPen(muted);
        painter->setFont(option.font);
        const QRect all(body.left(), r.top(), body.width(), r.height());
        painter->drawText(all, Qt::AlignVCenter | Qt::AlignLeft,
                          option.fontMetrics.elidedText(index.data(ChainModel::TypeText).toString(),
                                                        Qt::ElideMiddle, all.width()));
        painter->restore();
        return;
    }

    painter->setFont(bold);
    painter->setPen(text);
    // The name goes before the type where there is no room for both.
    const QFontMetrics boldMetrics(bold);
    const QString name =
        boldMetrics.elidedText(index.data(ChainModel::Title).toString(), Qt::ElideRight, body.width());
    painter->drawText(body, Qt::AlignVCenter | Qt::AlignLeft, name);
    painter->setFont(option.font);
    painter->setPen(muted);
    const int room = body.width() - boldMetrics.horizontalAdvance(name) - unit;
    painter->drawText(body, Qt::AlignVCenter | Qt::AlignRight,
                      option.fontMetrics.elidedText(index.data(ChainModel::TypeText).toString(),
                                                    Qt::ElideRight, qMax(0, room)));

    body.translate(0, line);
    const int side = qRound(option.fontMetrics.ascent() * 1.05);
    const auto activity = static_cast<Activity>(index.data(ChainModel::ActivityValue).toInt());
    paintActivity(*painter, QRectF(body.left(), body.center().y() - side / 2.0 + 0.5, side, side), activity,
                  palette);
    QString position = index.data(ChainModel::Position).toString();
    if (index.data(ChainModel::HomeIsKnown).toBool())
        position.prepend(u"⌂ "_s);
    QFont digits = look::tabular(option.font);
    const QRect word =
        body.adjusted(side + unit * 3 / 4, 0, -QFontMetrics(digits).horizontalAdvance(position) - unit, 0);
    painter->setPen(text);
    painter->drawText(word, Qt::AlignVCenter | Qt::AlignLeft,
                      option.fontMetrics.elidedText(index.data(ChainModel::ActivityText).toString(),
                                                    Qt::ElideRight, word.width()));
    digits.setStrikeOut(index.data(ChainModel::PositionIsOld).toBool());
    painter->setFont(digits);
    painter->setPen(digits.strikeOut() ? muted : text);
    painter->drawText(body, Qt::AlignVCenter | Qt::AlignRight, position);

    if (option.state.testFlag(QStyle::State_HasFocus)) {
        QStyleOptionFocusRect focus;
        focus.QStyleOption::operator=(option);
        focus.rect = r.adjusted(1, 1, -1, -1);
        QApplication::style()->drawPrimitive(QStyle::PE_FrameFocusRect, &focus, painter);
    }
    painter->restore();
}

QSize ChainDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const int height = option.fontMetrics.height();
    const bool host = index.data(ChainModel::IsHost).toBool();
    return {height * 15, host ? height * 5 / 2 : height * 13 / 4};
}

}  // namespace nmc
