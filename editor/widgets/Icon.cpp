#include "editor/widgets/Icon.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QSvgRenderer>

/// Resources of a static library must be registered before use.
static void registerIcons() { Q_INIT_RESOURCE(icons); }

namespace rubble {

namespace {

constexpr const char* kStrokeColour = "currentColor";  // in the SVG files

QColor colourFor(QIcon::Mode mode) {
    const QPalette palette = QGuiApplication::palette();
    if (mode == QIcon::Disabled) return palette.color(QPalette::Disabled, QPalette::WindowText);
    if (mode == QIcon::Selected) return palette.color(QPalette::HighlightedText);
    return palette.color(QPalette::WindowText);
}

/// Renders an SVG in the palette's current text colour.
class SvgIconEngine : public QIconEngine {
public:
    explicit SvgIconEngine(const QByteArray& svg) : m_svg(svg) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        QByteArray svg = m_svg;
        svg.replace(kStrokeColour, colourFor(mode).name().toLatin1());
        QSvgRenderer renderer(svg);
        painter->setRenderHint(QPainter::Antialiasing);
        if (mode == QIcon::Disabled) painter->setOpacity(kDisabledOpacity);
        renderer.render(painter, rect);
        painter->setOpacity(1.0);
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        const QString key = QString("rubble-icon-%1-%2-%3-%4-%5")
                                .arg(qHash(m_svg))
                                .arg(size.width())
                                .arg(size.height())
                                .arg(colourFor(mode).name())
                                .arg(static_cast<int>(mode));
        QPixmap drawn;
        if (QPixmapCache::find(key, &drawn)) return drawn;
        drawn = QPixmap(size);
        drawn.fill(Qt::transparent);
        QPainter painter(&drawn);
        paint(&painter, drawn.rect(), mode, state);
        painter.end();
        QPixmapCache::insert(key, drawn);
        return drawn;
    }
    QIconEngine* clone() const override { return new SvgIconEngine(m_svg); }

private:
    static constexpr double kDisabledOpacity = 0.5;
    QByteArray m_svg;
};

}  // namespace

QIcon iconNamed(const QString& name) {
    registerIcons();
    QFile file(":/icons/" + name + ".svg");
    return file.open(QIODevice::ReadOnly) ? QIcon(new SvgIconEngine(file.readAll())) : QIcon();
}

}  // namespace rubble
