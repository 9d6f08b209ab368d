#include "editor/widgets/ColourScheme.h"

#include <QApplication>
#include <QPainter>
#include <QProxyStyle>
#include <QStyleOption>

namespace rubble {

namespace {

/// The colours from which a palette is made. Texts have a contrast of at least 4.5 : 1 to what is behind them.
struct PaletteColours {
    QColor window, base, alternateBase, button, text, fadedText, line, highlight, highlightedText, link;
};

QPalette paletteOf(const PaletteColours& colours) {
    QPalette palette(colours.button, colours.window);
    palette.setColor(QPalette::Window, colours.window);
    palette.setColor(QPalette::Base, colours.base);
    palette.setColor(QPalette::AlternateBase, colours.alternateBase);
    palette.setColor(QPalette::Button, colours.button);
    palette.setColor(QPalette::ToolTipBase, colours.alternateBase);
    for (const QPalette::ColorRole role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
        palette.setColor(role, colours.text);
        palette.setColor(QPalette::Disabled, role, colours.fadedText);
    }
    palette.setColor(QPalette::PlaceholderText, colours.fadedText);
    palette.setColor(QPalette::BrightText, Qt::white);
    palette.setColor(QPalette::Mid, colours.line);
    palette.setColor(QPalette::Highlight, colours.highlight);
    palette.setColor(QPalette::HighlightedText, colours.highlightedText);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, colours.line);
    palette.setColor(QPalette::Link, colours.link);
    return palette;
}

/// Fusion draws the frame of check boxes in a darker shade of the window, which in a dark palette is the colour of the
/// box itself: here a lighter frame is drawn over it.
class Style : public QProxyStyle {
public:
    Style() : QProxyStyle("Fusion") {}

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        if (element != PE_IndicatorCheckBox || !isDark(option->palette)) return;
        const bool isEnabled = option->state.testFlag(State_Enabled);
        painter->save();
        painter->setPen(option->palette.color(isEnabled ? QPalette::PlaceholderText : QPalette::Mid));
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
        painter->restore();
    }
};

}  // namespace

QPalette lightPalette() {
    return paletteOf({.window = "#f1f0ee",
                      .base = "#ffffff",
                      .alternateBase = "#f7f6f4",
                      .button = "#e9e7e4",
                      .text = "#232323",
                      .fadedText = "#8b8883",
                      .line = "#c4c0ba",
                      .highlight = "#b45309",
                      .highlightedText = "#ffffff",
                      .link = "#9a4507"});
}

QPalette darkPalette() {
    return paletteOf({.window = "#2b2c2f",
                      .base = "#1f2023",
                      .alternateBase = "#26272a",
                      .button = "#393a3e",
                      .text = "#e4e2de",
                      .fadedText = "#85847f",
                      .line = "#4d4e53",
                      .highlight = "#d97706",
                      .highlightedText = "#18191b",
                      .link = "#f0a04b"});
}

bool isDark(const QPalette& palette) {
    return palette.color(QPalette::WindowText).lightness() > palette.color(QPalette::Window).lightness();
}

QPalette paletteOf(ColourScheme scheme, const QPalette& desktop, const QPalette& ofStyle) {
    if (scheme == ColourScheme::Light) return lightPalette();
    if (scheme == ColourScheme::Dark) return darkPalette();
    const bool isOfDesktop = desktop != ofStyle;
    if (isOfDesktop) return QPalette();
    return isDark(desktop) ? darkPalette() : lightPalette();
}

void applyTheme(ColourScheme scheme) {
    auto* style = new Style;
    QApplication::setStyle(style);
    QApplication::setPalette(QPalette());  // shows that of the desktop
    QApplication::setPalette(paletteOf(scheme, QApplication::palette(), style->standardPalette()));
}

}  // namespace rubble
