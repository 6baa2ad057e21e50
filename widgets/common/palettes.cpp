// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/palettes.h"

#include <QApplication>
#include <QHash>
#include <QIcon>
#include <QProxyStyle>
#include <QStyleOption>
#include <QWidget>

#include "widgets/common/icons.h"
#include "widgets/common/look.h"

namespace nmc::look {

using namespace Qt::StringLiterals;

namespace {

constexpr double kReadable = 4.5;       // WCAG 2.1, 1.4.3
constexpr double kHighContrast = 20.0;  // of 21

struct Colouring {
    QRgb window, text, base, button, highlight, highlightedText, link, visited, disabled;
};

constexpr Colouring kLight{0xEFEFEF, 0x1B1E20, 0xFFFFFF, 0xE8E8E8, 0x0B63A8,
                           0xFFFFFF, 0x0057AE, 0x6A3D9A, 0x767676};
constexpr Colouring kDark{0x2B2D30, 0xE8E8E8, 0x1E1F22, 0x3A3D41, 0x2A6FB0,
                          0xFFFFFF, 0x6CB6F5, 0xC9A6EC, 0x8C8C8C};
constexpr Colouring kHighContrastColours{0x000000, 0xFFFFFF, 0x000000, 0x000000, 0xFFFF00,
                                         0x000000, 0x66CCFF, 0xFFB3FF, 0xA0A0A0};

QPalette paletteOf(const Colouring& colouring) {
    const QColor text(colouring.text);
    QPalette palette(QColor(colouring.button), QColor(colouring.window));  // and shades of them
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText,
                            QPalette::BrightText})
        palette.setColor(role, text);
    for (const auto role : {QPalette::Base, QPalette::AlternateBase, QPalette::ToolTipBase})
        palette.setColor(role, QColor(colouring.base));
    palette.setColor(QPalette::Highlight, QColor(colouring.highlight));
    palette.setColor(QPalette::HighlightedText, QColor(colouring.highlightedText));
    palette.setColor(QPalette::Link, QColor(colouring.link));
    palette.setColor(QPalette::LinkVisited, QColor(colouring.visited));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, QColor(colouring.disabled));
    palette.setColor(QPalette::PlaceholderText, mutedText(palette));
    return palette;
}

/// Fusion makes its frames of the window's colour, darkened: of black nothing is left.
class Style : public QProxyStyle {
public:
    Style() : QProxyStyle(u"Fusion"_s) {}

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override {
        const bool framed = element == PE_FrameLineEdit || element == PE_PanelButtonCommand ||
                            element == PE_IndicatorCheckBox || element == PE_IndicatorRadioButton ||
                            element == PE_FrameTabWidget;
        const Frames frames(framed, *this, option);
        QProxyStyle::drawPrimitive(element, option, painter, widget);
    }
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
        const Frames frames(element == CE_TabBarTabShape, *this, option);
        QProxyStyle::drawControl(element, option, painter, widget);
    }
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget) const override {
        const Frames frames(control == CC_ComboBox || control == CC_SpinBox, *this, option);
        QProxyStyle::drawComplexControl(control, option, painter, widget);
    }
    /// Kept, since Fusion decodes its images each time, and each dock asks for two of them again and again.
    QIcon standardIcon(StandardPixmap which, const QStyleOption* option,
                       const QWidget* widget) const override {
        QIcon& icon = m_icons[which];
        if (icon.isNull())
            // Qt's own of the menu bar takes longer to find than the menu bar to build.
            icon = which == SP_ToolBarHorizontalExtensionButton
                       ? icons::tinted(u"arrow-bar-to-right"_s)
                       : QProxyStyle::standardIcon(which, option, widget);
        return icon;
    }

private:
    /// While it lives, the option's window is light where `framed` and its frame could not be seen.
    class Frames {
    public:
        Frames(bool framed, const Style& style, const QStyleOption* option)
            : m_option(framed && option != nullptr && isHighContrast(option->palette) &&
                               isDark(option->palette)
                           ? const_cast<QStyleOption*>(option)  // its maker's, and back as it was
                           : nullptr) {
            if (m_option != nullptr)
                m_option->palette = style.framed(m_before = option->palette);
        }
        ~Frames() {
            if (m_option != nullptr)
                m_option->palette = m_before;
        }
        Q_DISABLE_COPY_MOVE(Frames)

    private:
        QStyleOption* m_option;
        QPalette m_before;
    };

    /// The same one each time, by which Fusion finds what it has drawn before.
    const QPalette& framed(const QPalette& palette) const {
        if (m_framedFor != palette.cacheKey()) {
            m_framedFor = palette.cacheKey();
            m_framed = palette;
            m_framed.setColor(QPalette::Window, palette.color(QPalette::Active, QPalette::WindowText));
        }
        return m_framed;
    }

    mutable QHash<int, QIcon> m_icons;
    mutable qint64 m_framedFor = 0;
    mutable QPalette m_framed;
};

}  // namespace

QPalette paletteOf(Colours colours) {
    switch (colours) {
        case Colours::System:
            return {};
        case Colours::Light:
            return paletteOf(kLight);
        case Colours::Dark:
            return paletteOf(kDark);
        case Colours::HighContrast:
            return paletteOf(kHighContrastColours);
    }
    return {};
}

void useColours(Colours colours) {
    QApplication::setPalette(paletteOf(colours));
}

bool isHighContrast(const QPalette& palette) {
    return contrast(palette.color(QPalette::Active, QPalette::WindowText),
                    palette.color(QPalette::Active, QPalette::Window)) > kHighContrast;
}

QColor selectionTint(const QPalette& palette) {
    const QColor base = palette.color(QPalette::Active, QPalette::Base);
    const QColor highlight = palette.color(QPalette::Active, QPalette::Highlight);
    const float share = isDark(palette) ? 0.30F : 0.16F;
    const auto mixed = [share](float a, float b) { return a * (1.0F - share) + b * share; };
    return QColor::fromRgbF(mixed(base.redF(), highlight.redF()), mixed(base.greenF(), highlight.greenF()),
                            mixed(base.blueF(), highlight.blueF()));
}

void adoptReadable(QWidget* window) {
    const QPalette before = window->palette();
    QPalette palette = before;
    const QColor placeholder = mutedText(palette);
    if (palette.color(QPalette::Active, QPalette::PlaceholderText) != placeholder)
        palette.setColor(QPalette::PlaceholderText, placeholder);
    const QColor highlight = palette.color(QPalette::Active, QPalette::Highlight);
    if (contrast(palette.color(QPalette::Active, QPalette::HighlightedText), highlight) < kReadable) {
        const bool black = contrast(Qt::black, highlight) > contrast(Qt::white, highlight);
        palette.setColor(QPalette::HighlightedText, black ? Qt::black : Qt::white);
    }
    if (palette != before)
        window->setPalette(palette);
}

QStyle* newStyle() {
    return new Style;
}

}  // namespace nmc::look
