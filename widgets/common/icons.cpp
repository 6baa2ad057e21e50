// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/icons.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QSvgRenderer>

// Keeps the linker from dropping the resources of a static library. Must be outside of any namespace.
static void useResources() {
    Q_INIT_RESOURCE(nmcpanel);
}

namespace nmc::icons {

using namespace Qt::StringLiterals;

namespace {

class TintedIconEngine : public QIconEngine {
public:
    explicit TintedIconEngine(QString name) : m_name(std::move(name)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
        const qreal ratio = painter->device() != nullptr ? painter->device()->devicePixelRatioF() : 1.0;
        painter->drawPixmap(rect, scaledPixmap(rect.size() * ratio, mode, state, ratio));
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        return scaledPixmap(size, mode, state, 1.0);
    }
    QPixmap scaledPixmap(const QSize& size, QIcon::Mode mode, QIcon::State /*state*/, qreal scale) override {
        const QPalette palette = QGuiApplication::palette();
        QColor colour = palette.color(QPalette::Active, QPalette::ButtonText);
        if (mode == QIcon::Disabled)
            colour = palette.color(QPalette::Disabled, QPalette::ButtonText);
        else if (mode == QIcon::Selected)
            colour = palette.color(QPalette::Active, QPalette::HighlightedText);
        const int side = qMin(size.width(), size.height());
        return icons::pixmap(m_name, colour, qRound(side / scale), scale);
    }
    [[nodiscard]] QIconEngine* clone() const override { return new TintedIconEngine(m_name); }

private:
    QString m_name;
};

}  // namespace

QIcon window() {
    useResources();
    return QIcon(u":/icons/nmcpanel.svg"_s);
}

QIcon tinted(const QString& name) {
    return QIcon(new TintedIconEngine(name));
}

QPixmap pixmap(const QString& name, const QColor& colour, int size, qreal devicePixelRatio) {
    const QString key =
        u"nmc/%1/%2/%3/%4"_s.arg(name, colour.name(QColor::HexArgb)).arg(size).arg(devicePixelRatio);
    QPixmap result;
    if (QPixmapCache::find(key, &result))
        return result;
    useResources();
    QFile file(u":/icons/%1.svg"_s.arg(name));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QByteArray svg = file.readAll();
    svg.replace("currentColor", colour.name().toLatin1());
    QSvgRenderer renderer(svg);
    const int pixels = qMax(1, qRound(size * devicePixelRatio));
    result = QPixmap(pixels, pixels);
    result.fill(Qt::transparent);
    {
        QPainter painter(&result);
        renderer.render(&painter);
    }
    result.setDevicePixelRatio(devicePixelRatio);
    QPixmapCache::insert(key, result);
    return result;
}

}  // namespace nmc::icons
