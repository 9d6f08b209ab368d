#include "editor/Theme.h"

#include <QApplication>
#include <QPainter>
#include <QProxyStyle>
#include <QStyleOption>

namespace rubble {

namespace {

constexpr QRgb kAccent = 0xffd97706;  // of what is chosen: a warm orange that both themes bear

/// The few colours that a theme is made of.
struct Shades {
    QColor window, base, alternateBase, button, text, fadedText, line;
};

QPalette paletteOf(const Shades& shades) {
    QPalette palette(shades.button, shades.window);
    palette.setColor(QPalette::Window, shades.window);
    palette.setColor(QPalette::Base, shades.base);
    palette.setColor(QPalette::AlternateBase, shades.alternateBase);
    palette.setColor(QPalette::Button, shades.button);
    palette.setColor(QPalette::ToolTipBase, shades.alternateBase);
    for (const QPalette::ColorRole role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
        palette.setColor(role, shades.text);
        palette.setColor(QPalette::Disabled, role, shades.fadedText);
    }
    palette.setColor(QPalette::PlaceholderText, shades.fadedText);
    palette.setColor(QPalette::BrightText, Qt::white);
    palette.setColor(QPalette::Mid, shades.line);
    palette.setColor(QPalette::Highlight, QColor(kAccent));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, shades.line);
    palette.setColor(QPalette::Link, QColor(kAccent));
    return palette;
}

/// Fusion frames boxes to be ticked by a darker shade of the window: in a dark theme that is the shade within the box.
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
                      .line = "#c4c0ba"});
}

QPalette darkPalette() {
    return paletteOf({.window = "#2b2c2f",
                      .base = "#1f2023",
                      .alternateBase = "#26272a",
                      .button = "#393a3e",
                      .text = "#e4e2de",
                      .fadedText = "#85847f",
                      .line = "#4d4e53"});
}

bool isDark(const QPalette& palette) {
    return palette.color(QPalette::WindowText).lightness() > palette.color(QPalette::Window).lightness();
}

void applyTheme(ThemeChoice choice) {
    static const bool isSystemDark = isDark(QApplication::palette());  // before it was dressed the first time
    QApplication::setStyle(new Style);
    const bool wantsDark = choice == ThemeChoice::Dark || (choice == ThemeChoice::System && isSystemDark);
    QApplication::setPalette(wantsDark ? darkPalette() : lightPalette());
}

}  // namespace rubble
