// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/elidedlabel.h"

#include <QHelpEvent>
#include <QPainter>
#include <QStyle>
#include <QTextLayout>
#include <QToolTip>
#include <QtMath>

namespace nmc {

ElidedLabel::ElidedLabel(int lines, QWidget* parent) : QLabel(parent), m_lines(lines) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

QSize ElidedLabel::sizeHint() const {
    // Rounded up: in half a pixel less, the text would be elided.
    return {qCeil(QFontMetricsF(font()).horizontalAdvance(text())), minimumSizeHint().height()};
}

QSize ElidedLabel::minimumSizeHint() const {
    return {fontMetrics().horizontalAdvance(u'…'), m_lines * fontMetrics().lineSpacing()};
}

bool ElidedLabel::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip && toolTip().isEmpty() && visibleText() != text()) {
        QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), text(), this);
        return true;
    }
    return QLabel::event(event);
}

QString ElidedLabel::visibleText() const {
    const int width = contentsRect().width();
    QString words = text();
    words.replace(u'\n', u' ');
    QTextLayout layout(words, font());
    QStringList lines;
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(width);
        const QString rest = words.mid(line.textStart());
        const bool last = lines.size() + 1 == m_lines;
        lines << (last ? fontMetrics().elidedText(rest, Qt::ElideRight, width)
                       : rest.left(line.textLength()));
        if (last)
            break;
    }
    layout.endLayout();
    return lines.join(u'\n');
}

void ElidedLabel::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    style()->drawItemText(&painter, contentsRect(), static_cast<int>(alignment()), palette(), isEnabled(),
                          visibleText(), foregroundRole());
}

ElidedLabel* newMutedLine(QWidget* parent, const QString& objectName) {
    auto* label = new ElidedLabel(1, parent);
    label->setObjectName(objectName);
    label->setForegroundRole(QPalette::PlaceholderText);
    return label;
}

}  // namespace nmc
