#include "editor/SceneLegend.h"

#include "core/asset/PieceColours.h"
#include "editor/HudPlate.h"
#include "editor/canvas/LabelPainting.h"

#include <QEvent>
#include <QLocale>

#include <algorithm>

namespace rubble {

namespace {

constexpr int kMargin = 12;  // this and the following: points
constexpr int kScaleWidth = 150;
constexpr int kScaleHeight = 11;
constexpr int kSample = 18;
constexpr int kBetween = 6;
const QColor kBondColour(250, 140, 26);

QString titleOf(SceneColouring colouring) {
    switch (colouring) {
        case SceneColouring::Level: return SceneLegend::tr("Level");
        case SceneColouring::Volume: return SceneLegend::tr("Volume of the piece");
        case SceneColouring::Mass: return SceneLegend::tr("Mass of the piece");
        case SceneColouring::Aspect: return SceneLegend::tr("Length : width");
        case SceneColouring::Threshold: return SceneLegend::tr("Comes loose at");
        case SceneColouring::Material:
        case SceneColouring::Piece: break;
    }
    return {};
}

QString figureText(SceneColouring colouring, double value) {
    switch (colouring) {
        case SceneColouring::Volume: return volumeText(value);
        case SceneColouring::Mass: return massText(value);
        case SceneColouring::Aspect: return QLocale().toString(value, 'f', 1);
        case SceneColouring::Threshold: return impulseText(value);
        default: return QLocale().toString(value, 'f', 0);
    }
}

}  // namespace

SceneLegend::SceneLegend(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    setAccessibleName(tr("Legend"));
    setObjectName("scene-legend");
    parent->installEventFilter(this);
    hide();
}

void SceneLegend::setContent(const Content& content) {
    if (content == m_content) return;
    m_content = content;
    setAccessibleDescription(texts().join(", "));
    setVisible(!texts().isEmpty());
    place();
    raise();
    update();
}

QStringList SceneLegend::texts() const {
    QStringList texts;
    if (m_content.range) {
        const auto& [least, most] = *m_content.range;
        texts = {titleOf(m_content.colouring), figureText(m_content.colouring, least)};
        if (most > least) texts.append(figureText(m_content.colouring, most));
    }
    if (m_content.largestBond > 0.0) texts.append(tr("Pieces that share %1").arg(areaText(m_content.largestBond)));
    return texts;
}

bool SceneLegend::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parent() && event->type() == QEvent::Resize) place();
    return QWidget::eventFilter(watched, event);
}

/// In the upper right corner, as large as it has to be.
void SceneLegend::place() {
    const QFontMetrics lines(font());
    int width = m_content.range ? kScaleWidth : 0, height = 2 * kPlatePadding - 4;
    for (const QString& text : texts()) width = std::max(width, lines.horizontalAdvance(text));
    if (m_content.range) height += 2 * lines.height() + kScaleHeight + 2;
    if (m_content.largestBond > 0.0) {
        width = std::max(width, kSample + kBetween + lines.horizontalAdvance(texts().back()));
        height += lines.height() + (m_content.range ? kBetween : 0);
    }
    const QSize size(width + 2 * kPlatePadding, height);
    setGeometry(QRect(QPoint(parentWidget()->width() - size.width() - kMargin, kMargin), size));
}

void SceneLegend::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QRect inside = paintPlate(painter, rect());
    const QStringList told = texts();
    const int line = painter.fontMetrics().height();
    painter.setPen(kPlateInk);
    if (m_content.range) {
        painter.drawText(inside, Qt::AlignTop | Qt::AlignLeft, told[0]);
        const QRect bar(inside.left(), inside.top() + line + 1, inside.width(), kScaleHeight);
        const bool isOne = m_content.range->most <= m_content.range->least;
        for (int x = 0; x < bar.width(); ++x) {
            const double share = isOne ? 0.5 : static_cast<double>(x) / (bar.width() - 1);
            painter.fillRect(QRect(bar.left() + x, bar.top(), 1, bar.height()), QColor(packed(rampColour(share))));
        }
        const QRect ends(bar.left(), bar.bottom() + 2, bar.width(), line);
        painter.setPen(kPlateFaintInk);
        if (isOne) painter.drawText(ends, Qt::AlignHCenter | Qt::AlignTop, tr("all: %1").arg(told[1]));
        if (!isOne) painter.drawText(ends, Qt::AlignLeft | Qt::AlignTop, told[1]);
        if (!isOne) painter.drawText(ends, Qt::AlignRight | Qt::AlignTop, told[2]);
        inside.setTop(ends.bottom() + kBetween);
    }
    if (m_content.largestBond <= 0.0) return;
    painter.setPen(QPen(kBondColour, 7.0, Qt::SolidLine, Qt::RoundCap));
    const int middle = inside.top() + line / 2;
    painter.drawLine(inside.left() + 4, middle, inside.left() + kSample - 4, middle);
    painter.setPen(kPlateFaintInk);
    painter.drawText(inside.adjusted(kSample + kBetween, 0, 0, 0), Qt::AlignTop | Qt::AlignLeft, told.back());
}

}  // namespace rubble
