// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/look.h"

#include <QAction>
#include <QApplication>
#include <QEvent>
#include <QFontDatabase>
#include <QFontMetricsF>
#include <QIcon>
#include <QLabel>
#include <array>
#include <cmath>

#include "widgets/common/accessibility.h"
#include "widgets/common/icons.h"
#include "widgets/common/palettes.h"

namespace nmc::look {

using namespace Qt::StringLiterals;

namespace {

double linear(double channel) {
    return channel <= 0.03928 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& colour) {
    return 0.2126 * linear(static_cast<double>(colour.redF())) +
           0.7152 * linear(static_cast<double>(colour.greenF())) +
           0.0722 * linear(static_cast<double>(colour.blueF()));
}

/// A label in the muted colour of its parent's palette. It keeps its height while it is empty, so that
/// nothing moves when it gets a text.
class MutedLabel : public QLabel {
public:
    MutedLabel(const QString& text, QWidget* parent) : QLabel(text, parent) {
        setMinimumHeight(fontMetrics().height());
        adopt();
    }

protected:
    void changeEvent(QEvent* event) override {
        QLabel::changeEvent(event);
        if (event->type() == QEvent::PaletteChange || event->type() == QEvent::ParentChange)
            adopt();
    }

private:
    void adopt() {
        const QPalette base = parentWidget() != nullptr ? parentWidget()->palette() : QApplication::palette();
        const QColor colour = mutedText(base);
        if (palette().color(QPalette::Active, QPalette::WindowText) == colour)
            return;
        QPalette own;
        own.setColor(QPalette::WindowText, colour);
        setPalette(own);
    }
};

}  // namespace

void setUp(QApplication& application) {
    application.setStyle(newStyle());
    QApplication::setWindowIcon(icons::window());
    QApplication::setDesktopFileName(u"org.nmcpanel.NmcPanel"_s);
    accessibility::setUp();
}

bool isDark(const QPalette& palette) {
    return luminance(palette.color(QPalette::Window)) < luminance(palette.color(QPalette::WindowText));
}

double contrast(const QColor& a, const QColor& b) {
    const double la = luminance(a);
    const double lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

QColor mutedText(const QPalette& palette) {
    const QColor text = palette.color(QPalette::Active, QPalette::WindowText);
    const QColor window = palette.color(QPalette::Active, QPalette::Window);
    const QColor base = palette.color(QPalette::Active, QPalette::Base);
    const QColor selected = selectionTint(palette);
    const double least = isHighContrast(palette) ? 7.0 : 4.6;
    for (float share = 0.42F; share > 0.0F; share -= 0.06F) {
        const QColor colour = mixed(text, window, share);
        if (contrast(colour, window) >= least && contrast(colour, base) >= least &&
            contrast(colour, selected) >= 4.6)
            return colour;
    }
    return text;
}

QColor faintLine(const QPalette& palette) {
    return mixed(palette.color(QPalette::WindowText), palette.color(QPalette::Base),
                 isDark(palette) ? 0.75F : 0.82F);
}

QColor severityFill(Severity severity, const QPalette& palette) {
    switch (severity) {
        case Severity::Normal:
            return palette.color(QPalette::Active, QPalette::WindowText);
        case Severity::Attention:
            return {0xE6, 0x9F, 0x00};
        case Severity::Fault:
            return {0xD5, 0x5E, 0x00};
    }
    return {};
}

QColor onSeverityFill(Severity severity, const QPalette& palette) {
    return severity == Severity::Normal ? palette.color(QPalette::Active, QPalette::Window) : Qt::black;
}

QColor severityTint(Severity severity, const QPalette& palette) {
    const QColor window = palette.color(QPalette::Active, QPalette::Window);
    if (severity == Severity::Normal)
        return mixed(window, palette.color(QPalette::Active, QPalette::WindowText), 0.04F);
    return mixed(window, severityFill(severity, palette), isDark(palette) ? 0.20F : 0.22F);
}

QColor traceColour(int trace, const QPalette& palette) {
    // The colours of Okabe and Ito, darkened on white to a contrast of 3:1; vermillion is reserved for
    // faults.
    static const std::array<QRgb, kTraceColours> light{0x0072B2, 0xA86A00, 0xA34D7C,
                                                       0x00795A, 0x6A6A6A, 0x3B6FD4};
    static const std::array<QRgb, kTraceColours> dark{0x56B4E9, 0xE69F00, 0xCC79A7,
                                                      0x2FC7A0, 0xB8B8B8, 0xF0E442};
    return {(isDark(palette) ? dark : light)[static_cast<std::size_t>(trace % kTraceColours)]};
}

QFont tabular(const QFont& base) {
    const QFontMetricsF metrics(base);
    for (char16_t digit = u'1'; digit <= u'9'; ++digit) {
        if (std::abs(metrics.horizontalAdvance(QChar(digit)) - metrics.horizontalAdvance(u'0')) > 0.01) {
            QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
            if (base.pointSizeF() > 0)
                fixed.setPointSizeF(base.pointSizeF());
            else
                fixed.setPixelSize(base.pixelSize());
            fixed.setWeight(base.weight());
            return fixed;
        }
    }
    return base;
}

QFont scaled(const QFont& base, double factor) {
    QFont font = base;
    if (base.pointSizeF() > 0)
        font.setPointSizeF(base.pointSizeF() * factor);
    else
        font.setPixelSize(qRound(base.pixelSize() * factor));
    return font;
}

int millimetres(const QWidget* widget, double mm) {
    return static_cast<int>(std::ceil(mm / 25.4 * widget->logicalDpiY()));
}

int gridUnit(const QWidget* widget) {
    return qMax(4, widget->fontMetrics().height() / 2);
}

void setText(QLabel* label, const QString& text) {
    if (label->text() != text)
        label->setText(text);
}

void setOld(QLabel* label, bool old) {
    QFont font = label->font();
    if (font.strikeOut() == old)
        return;
    font.setStrikeOut(old);
    label->setFont(font);
    label->setForegroundRole(old ? QPalette::PlaceholderText : QPalette::WindowText);
}

void setReadout(QLabel* label, const QString& text) {
    if (label->text() == text)
        return;
    // A label of fixed size causes no new layout when its text changes.
    const QMargins margins = label->contentsMargins();
    const QSize needed(
        label->fontMetrics().horizontalAdvance(text) + margins.left() + margins.right() + gridUnit(label),
        label->fontMetrics().height() + margins.top() + margins.bottom());
    const bool first = label->maximumWidth() == QWIDGETSIZE_MAX;
    if (first || needed.width() > label->width() || needed.height() > label->height())
        label->setFixedSize(first ? needed : needed.expandedTo(label->size()));
    label->setText(text);
}

QLabel* newMutedLabel(const QString& text, QWidget* parent, const QString& objectName) {
    auto* label = new MutedLabel(text, parent);
    label->setObjectName(objectName);
    return label;
}

QAction* newAction(QObject* parent, const QString& objectName, const QString& text, const QString& meaning,
                   const QKeySequence& key) {
    auto* action = new QAction(text, parent);
    action->setObjectName(objectName);
    action->setToolTip(meaning);
    action->setShortcut(key);
    return action;
}

void keepRoom(QWidget* widget) {
    QSizePolicy policy = widget->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    widget->setSizePolicy(policy);
}

void showInFront(QWidget* window) {
    window->show();
    window->raise();
    window->activateWindow();
}

void name(QWidget* widget, const QString& objectName, const QString& accessibleName) {
    widget->setObjectName(objectName);
    widget->setAccessibleName(accessibleName);
}

QString nameFor(ModuleType type, const QString& objectName) {
    return type == ModuleType::Stepper ? u"stepper"_s + objectName.left(1).toUpper() + objectName.mid(1)
                                       : objectName;
}

void nameText(QLabel* label, const QString& objectName, const QString& what) {
    label->setObjectName(objectName);
    label->setAccessibleDescription(what);
}

void setPossible(QWidget* control, const QString& reason, const QString& meaning) {
    control->setEnabled(reason.isEmpty());
    const QString& tip = reason.isEmpty() ? meaning : reason;
    if (control->toolTip() == tip)
        return;
    control->setToolTip(tip);
    control->setAccessibleDescription(tip);
}

}  // namespace nmc::look
