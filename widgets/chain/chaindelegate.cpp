// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chain/chaindelegate.h"

#include <QApplication>
#include <QPainter>

#include "widgets/chain/chainmodel.h"
#include "widgets/common/glyphs.h"
#include "widgets/common/look.h"
#include "widgets/common/palettes.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

int unitOf(const QStyleOptionViewItem& option) {
    return qMax(4, option.fontMetrics.height() / 2);
}

int wireWidth(const QStyleOptionViewItem& option) {
    return option.fontMetrics.height() * 5 / 2;
}

/// The first of the two lines of text beside the wire.
QRect firstLine(const QStyleOptionViewItem& option) {
    const int unit = unitOf(option);
    const QRect& r = option.rect;
    const int line = option.fontMetrics.height() * 5 / 4;
    QRect body(r.left() + unit / 2 + wireWidth(option) + unit, r.center().y() - line, 0, line);
    body.setRight(r.right() - unit);
    return body;
}

QRect secondLine(const QStyleOptionViewItem& option) {
    const QRect line = firstLine(option);
    return line.translated(0, line.height());
}

QString positionOf(const QModelIndex& index) {
    const QString position = index.data(ChainModel::Position).toString();
    return index.data(ChainModel::HomeIsKnown).toBool() ? u"⌂ "_s + position : position;
}

/// A text as wide as any position with the same number of digits.
QString widthOf(QString position) {
    for (QChar& c : position)
        if (c.isDigit())
            c = u'0';
    return position;
}

}  // namespace

void ChainDelegate::paintWire(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index,
                              const QRect& column) {
    const bool host = index.data(ChainModel::IsHost).toBool();
    const double pen = qMax(1.5, option.fontMetrics.height() / 9.0);
    painter.setPen(QPen(look::mutedText(option.palette), pen));
    const int x = column.center().x();
    const int top = index.row() == 0 ? column.center().y() : column.top();
    const int bottom = host ? column.center().y() : column.bottom() + 1;
    painter.drawLine(x, top, x, bottom);

    const QString text = host ? index.data(ChainModel::Name).toString()
                              : QString::number(index.data(ChainModel::Address).toInt());
    QFont font = option.font;
    font.setBold(true);
    painter.setFont(font);
    const int height = option.fontMetrics.height() + unitOf(option) / 2;
    const int width = qMax(height, QFontMetrics(font).horizontalAdvance(text) + unitOf(option));
    const QRectF node(x - width / 2.0 + 0.5, column.center().y() - height / 2.0 + 0.5, width, height);
    painter.setBrush(option.palette.color(QPalette::Base));
    const double radius = host ? height / 6.0 : height / 2.0;
    painter.drawRoundedRect(node, radius, radius);
    painter.setPen(option.palette.color(QPalette::Active, QPalette::Text));
    painter.drawText(node, Qt::AlignCenter, text);
}

void ChainDelegate::paintTexts(QPainter& painter, const QStyleOptionViewItem& option,
                               const QModelIndex& index, const QFont& digits) {
    const QPalette& palette = option.palette;
    const int unit = unitOf(option);
    const QColor text = palette.color(QPalette::Active, QPalette::Text);
    const QColor muted = look::mutedText(palette);
    const QRect first = firstLine(option);
    if (index.data(ChainModel::IsHost).toBool()) {
        painter.setPen(muted);
        painter.setFont(option.font);
        const QRect all(first.left(), option.rect.top(), first.width(), option.rect.height());
        painter.drawText(all, Qt::AlignVCenter | Qt::AlignLeft,
                         option.fontMetrics.elidedText(index.data(ChainModel::TypeText).toString(),
                                                       Qt::ElideMiddle, all.width()));
        return;
    }
    QFont bold = option.font;
    bold.setBold(true);
    painter.setFont(bold);
    painter.setPen(text);
    // The name has priority over the type if there is no room for both.
    const QFontMetrics boldMetrics(bold);
    const QString name =
        boldMetrics.elidedText(index.data(ChainModel::Title).toString(), Qt::ElideRight, first.width());
    painter.drawText(first, Qt::AlignVCenter | Qt::AlignLeft, name);
    painter.setFont(option.font);
    painter.setPen(muted);
    const int room = first.width() - boldMetrics.horizontalAdvance(name) - unit;
    painter.drawText(first, Qt::AlignVCenter | Qt::AlignRight,
                     option.fontMetrics.elidedText(index.data(ChainModel::TypeText).toString(),
                                                   Qt::ElideRight, qMax(0, room)));

    const QRect second = secondLine(option);
    const int side = qRound(option.fontMetrics.ascent() * 1.05);
    const auto activity = static_cast<Activity>(index.data(ChainModel::ActivityValue).toInt());
    paintActivity(painter, QRectF(second.left(), second.center().y() - side / 2.0 + 0.5, side, side),
                  activity, palette);
    const int position = QFontMetrics(digits).horizontalAdvance(widthOf(positionOf(index)));
    const QRect word = second.adjusted(side + unit * 3 / 4, 0, -position - unit, 0);
    painter.setPen(text);
    painter.drawText(word, Qt::AlignVCenter | Qt::AlignLeft,
                     option.fontMetrics.elidedText(index.data(ChainModel::ActivityText).toString(),
                                                   Qt::ElideRight, word.width()));
}

void ChainDelegate::paintStill(QPainter& painter, const QStyleOptionViewItem& option,
                               const QModelIndex& index, const QFont& digits) {
    painter.setRenderHint(QPainter::Antialiasing);
    const QPalette& palette = option.palette;
    const QRect& r = option.rect;
    const int unit = unitOf(option);
    if (option.state.testFlag(QStyle::State_Selected)) {
        // A tint and a bar, not the full highlight: the states keep their colours and their contrast.
        painter.fillRect(r, look::selectionTint(palette));
        painter.fillRect(QRect(r.left(), r.top(), qMax(3, unit / 2), r.height()),
                         palette.color(QPalette::Active, QPalette::Highlight));
    }
    paintWire(painter, option, index, QRect(r.left() + unit / 2, r.top(), wireWidth(option), r.height()));
    paintTexts(painter, option, index, digits);
    if (option.state.testFlag(QStyle::State_HasFocus) && !index.data(ChainModel::IsHost).toBool()) {
        QStyleOptionFocusRect focus;
        focus.QStyleOption::operator=(option);
        focus.rect = r.adjusted(1, 1, -1, -1);
        QApplication::style()->drawPrimitive(QStyle::PE_FrameFocusRect, &focus, &painter);
    }
}

const ChainDelegate::Still& ChainDelegate::stillOf(const QStyleOptionViewItem& option,
                                                   const QModelIndex& index, double devicePixelRatio) const {
    Look look{option.font,
              option.palette.cacheKey(),
              option.state,
              option.rect.size(),
              devicePixelRatio,
              index.data(ChainModel::ActivityValue).toInt(),
              index.data(ChainModel::Address).toInt(),
              {widthOf(positionOf(index))}};
    for (const int role :
         {ChainModel::Name, ChainModel::Title, ChainModel::TypeText, ChainModel::ActivityText})
        look.texts << index.data(role).toString();
    Still& still = m_still[index.row()];
    if (still.look != look) {
        still.look = std::move(look);
        still.digits = look::tabular(option.font);
        still.picture = QPixmap(option.rect.size() * devicePixelRatio);
        still.picture.setDevicePixelRatio(devicePixelRatio);
        still.picture.fill(option.palette.color(QPalette::Base));
        QStyleOptionViewItem own = option;
        own.rect.moveTo(0, 0);
        QPainter painter(&still.picture);
        paintStill(painter, own, index, still.digits);
    }
    return still;
}

void ChainDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const {
    const Still& still = stillOf(option, index, painter->device()->devicePixelRatioF());
    painter->drawPixmap(option.rect.topLeft(), still.picture);
    if (index.data(ChainModel::IsHost).toBool())
        return;
    painter->save();
    QFont digits = still.digits;
    digits.setStrikeOut(index.data(ChainModel::PositionIsOld).toBool());
    painter->setFont(digits);
    painter->setPen(digits.strikeOut() ? look::mutedText(option.palette)
                                       : option.palette.color(QPalette::Active, QPalette::Text));
    painter->drawText(secondLine(option), Qt::AlignVCenter | Qt::AlignRight, positionOf(index));
    painter->restore();
}

QSize ChainDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const int height = option.fontMetrics.height();
    const bool host = index.data(ChainModel::IsHost).toBool();
    return {height * 15, host ? height * 5 / 2 : height * 13 / 4};
}

}  // namespace nmc
