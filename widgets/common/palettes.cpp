// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/palettes.h"

#include <QApplication>
#include <QHash>
#include <QIcon>
#include <QLabel>
#include <QProxyStyle>
#include <QStyleOption>
#include <QWidget>
#include <array>

#include "widgets/common/icons.h"
#include "widgets/common/look.h"

namespace nmc::look {

using namespace Qt::StringLiterals;

namespace {

constexpr double kReadable = 4.5;       // WCAG 2.1, 1.4.3
constexpr double kSeen = 3.0;           // WCAG 2.1, 1.4.11: anything but text
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
    QPalette palette(QColor(colouring.button), QColor(colouring.window));  // derives the other shades
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

/// The colour of a role, moved towards the text colour until Fusion's shades of it, `drawn`, are visible on
/// every background of a frame.
template <typename Drawn>
QColor seenAs(QPalette::ColorRole wanted, const QPalette& palette, const Drawn& drawn) {
    const QColor colour = palette.color(QPalette::Active, wanted);
    const QColor text = palette.color(QPalette::Active, QPalette::WindowText);
    const auto seen = [&](const QColor& tried) {
        for (const QColor& shade : drawn(tried))
            for (const auto role : {QPalette::Window, QPalette::Base})
                if (contrast(shade, palette.color(QPalette::Active, role)) < kSeen)
                    return false;
        return true;
    };
    constexpr int kSteps = 50;
    for (int step = 0; step < kSteps; ++step)
        if (const QColor tried = mixed(colour, text, static_cast<float>(step) / kSteps); seen(tried))
            return tried;
    return text;
}

/// Fusion with visible frames: its own are darkened shades of the window colour, or of the highlight where
/// the focus is, and disappear on dark windows. Labels have no markup.
class Style : public QProxyStyle {
public:
    Style() : QProxyStyle(u"Fusion"_s) {}

    using QProxyStyle::polish;
    /// Names, units and paths are shown as they are, also where they look like markup; a tool tip is a label.
    void polish(QWidget* widget) override {
        QProxyStyle::polish(widget);
        if (auto* label = qobject_cast<QLabel*>(widget))
            label->setTextFormat(Qt::PlainText);
    }
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override {
        const bool framed = element == PE_Frame || element == PE_FrameLineEdit ||
                            element == PE_PanelButtonCommand || element == PE_IndicatorCheckBox ||
                            element == PE_IndicatorRadioButton || element == PE_FrameTabWidget;
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
        const Frames frames(control == CC_ComboBox || control == CC_SpinBox || control == CC_Slider ||
                                control == CC_ScrollBar,
                            *this, option);
        QProxyStyle::drawComplexControl(control, option, painter, widget);
    }
    /// Half of Fusion's space beside the words of a tab, so that more tabs fit into a bar.
    int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override {
        const int pixels = QProxyStyle::pixelMetric(metric, option, widget);
        return metric == PM_TabBarTabHSpace ? pixels / 2 : pixels;
    }
    /// Caches the icons, because Fusion decodes its images each time, and each dock requests two of them
    /// again and again.
    QIcon standardIcon(StandardPixmap which, const QStyleOption* option,
                       const QWidget* widget) const override {
        QIcon& icon = m_icons[static_cast<int>(which)];
        if (icon.isNull())
            // Finding Qt's own icon for the menu bar takes longer than building the menu bar.
            icon = which == SP_ToolBarHorizontalExtensionButton
                       ? icons::tinted(u"arrow-bar-to-right"_s)
                       : QProxyStyle::standardIcon(which, option, widget);
        return icon;
    }

private:
    /// While it exists, the option has colours from which Fusion makes visible frames.
    class Frames {
    public:
        Frames(bool framed, const Style& style, const QStyleOption* option)
            : m_option(framed && option != nullptr
                           ? const_cast<QStyleOption*>(option)  // restored by the destructor
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

    /// Returns the same palette each time, so that Fusion finds what it has drawn before.
    QPalette framed(const QPalette& palette) const {
        constexpr qsizetype kMostPalettes = 100;
        if (const auto known = m_framed.constFind(palette.cacheKey()); known != m_framed.cend())
            return framedFor(*known, palette);
        if (m_framed.size() >= kMostPalettes)
            m_framed.clear();
        QPalette framed = palette;
        const auto frame = [](const QColor& c) {
            return std::array{c.darker(140), c.darker(140).lighter(110)};
        };
        framed.setColor(QPalette::Window, isHighContrast(palette)
                                              ? palette.color(QPalette::Active, QPalette::WindowText)
                                              : seenAs(QPalette::Window, palette, frame));
        framed.setColor(QPalette::Highlight, seenAs(QPalette::Highlight, palette, [](const QColor& c) {
                            return std::array{c.darker(125)};
                        }));
        m_framed.insert(framed.cacheKey(), framed);  // a combo box draws a button with the same option
        m_framed.insert(palette.cacheKey(), framed);
        return framedFor(framed, palette);
    }
    /// With the present colour group of `palette`: the control may be disabled.
    static QPalette framedFor(QPalette framed, const QPalette& palette) {
        framed.setCurrentColorGroup(palette.currentColorGroup());
        return framed;
    }

    mutable QHash<int, QIcon> m_icons;
    mutable QHash<qint64, QPalette> m_framed;  ///< by the cache key of the original palette
};

}  // namespace

QColor mixed(const QColor& a, const QColor& b, float shareOfB) {
    const auto mix = [shareOfB](float x, float y) { return x * (1.0F - shareOfB) + y * shareOfB; };
    return QColor::fromRgbF(mix(a.redF(), b.redF()), mix(a.greenF(), b.greenF()), mix(a.blueF(), b.blueF()));
}

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
    return mixed(base, highlight, isDark(palette) ? 0.30F : 0.16F);
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
