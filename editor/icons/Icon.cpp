#include "editor/icons/Icon.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QSvgRenderer>

/// The drawings lie in a static library: they are not there before this was called.
static void initDrawings() { Q_INIT_RESOURCE(icons); }

namespace rubble {

namespace {

constexpr const char* kInk = "currentColor";  // how the drawings name the colour of their lines

QColor inkFor(QIcon::Mode mode) {
    const QPalette palette = QGuiApplication::palette();
    if (mode == QIcon::Disabled) return palette.color(QPalette::Disabled, QPalette::WindowText);
    if (mode == QIcon::Selected) return palette.color(QPalette::HighlightedText);
    return palette.color(QPalette::WindowText);
}

/// Draws a drawing in the palette's colours whenever it is asked to.
class InkEngine : public QIconEngine {
public:
    explicit InkEngine(const QByteArray& svg) : m_svg(svg) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        QByteArray svg = m_svg;
        svg.replace(kInk, inkFor(mode).name().toLatin1());
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
                                .arg(inkFor(mode).name())
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
    QIconEngine* clone() const override { return new InkEngine(m_svg); }

private:
    static constexpr double kDisabledOpacity = 0.5;
    QByteArray m_svg;
};

}  // namespace

QIcon iconNamed(const QString& name) {
    initDrawings();
    QFile file(":/icons/" + name + ".svg");
    return file.open(QIODevice::ReadOnly) ? QIcon(new InkEngine(file.readAll())) : QIcon();
}

}  // namespace rubble
