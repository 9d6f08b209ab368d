#include "editor/canvas/PatternCanvas.h"

#include "editor/canvas/GridPainting.h"
#include "editor/canvas/SeedTool.h"

#include <QContextMenuEvent>
#include <QNativeGestureEvent>
#include <QPainterPath>

#include <cmath>

namespace rubble {

namespace {

constexpr double kMargin = 24.0;        // pixels around what is fitted
constexpr double kAroundChange = 10.0;  // pixels that signs and lines reach beyond what changed
constexpr double kZoomPerNotch = 1.2;
constexpr double kAnglePerNotch = 120.0;  // as Qt counts a wheel's turning

}  // namespace

PatternCanvas::PatternCanvas(Document& document, Selection& selection, const Bakes& bakes, QWidget* parent)
    : QWidget(parent),
      m_bakes(bakes),
      m_state{.document = document, .selection = selection},
      m_colours(canvasColours(palette())),
      m_seedTool(std::make_unique<SeedTool>(m_state)),
      m_tool(m_seedTool.get()) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(tr("Pattern canvas"));
    setAccessibleDescription(tr("The outline of the asset at hand, its seeds and the cells they make."));
    connect(&document, &Document::changed, this, &PatternCanvas::takeChanges);
    connect(&selection, &Selection::assetChanged, this, &PatternCanvas::takeAsset);
    connect(&selection, &Selection::seedsChanged, this, &PatternCanvas::toolChanged);
    connect(&selection, &Selection::hiddenChanged, this, [this] {
        m_contents.hiddenSeeds = m_state.selection.hiddenSeeds();
        repaintAll();
    });
    connect(&bakes, &Bakes::patternChanged, this, [this](Id asset) {
        if (asset == m_state.selection.asset()) takePattern();
    });
    connect(m_tool, &CanvasTool::changed, this, &PatternCanvas::toolChanged);
    connect(m_tool, &CanvasTool::said, this, &PatternCanvas::said);
    takeAsset();
}

PatternCanvas::~PatternCanvas() = default;

void PatternCanvas::setLayers(const CanvasLayers& layers) {
    if (layers == m_contents.layers) return;
    m_contents.layers = layers;
    if (m_contents.pattern) m_contents.range = m_contents.pattern->range(layers.colouring);
    repaintAll();
    emit layersChanged();
}

void PatternCanvas::setView(const CanvasView& view) {
    m_isFitted = false;
    m_state.view = view;
    m_state.view.size = size();
    update();
}

void PatternCanvas::fit() {
    m_isFitted = true;
    const Asset* asset = m_state.asset();
    if (!asset) return;
    // Rulers cover two of the edges.
    CanvasView view = m_state.view;
    view.size = QSizeF(size()) - QSizeF(kRulerWidth, kRulerWidth);
    view = fitted(view, boundsOf(asset->prism.outline.outer), kMargin);
    view.size = size();
    m_state.view = panned(view, {kRulerWidth / 2.0, kRulerWidth / 2.0});
    update();
}

void PatternCanvas::zoomBy(double factor) { setView(zoomed(m_state.view, factor, rect().center())); }

QString PatternCanvas::hint() const { return m_tool->hint(); }

void PatternCanvas::takeChanges(const Changes& changes) {
    if (changes.touches(Part::Asset, m_state.selection.asset())) {
        if (!m_state.asset()) takeAsset();
        update();
    }
}

void PatternCanvas::takeAsset() {
    m_tool->cancel();
    m_contents.hiddenSeeds = m_state.selection.hiddenSeeds();
    takePattern();
    fit();
    repaintAll();
}

void PatternCanvas::takePattern() {
    const std::shared_ptr<const BakedPattern> baked = m_bakes.findPattern(m_state.selection.asset());
    const std::shared_ptr<const ShownPattern> before = m_contents.pattern;
    const ShownPattern::Range range = m_contents.range;
    m_contents.pattern = baked && !baked->fault ? std::make_shared<const ShownPattern>(baked) : nullptr;
    m_contents.range =
        m_contents.pattern ? m_contents.pattern->range(m_contents.layers.colouring) : ShownPattern::Range{};
    m_state.pattern = m_contents.pattern;
    if (before && m_contents.pattern && range == m_contents.range) {
        repaintPart(differenceBox(*before, *m_contents.pattern));
    } else {
        repaintAll();
    }
    m_hovered = m_pointer && m_contents.pattern ? m_contents.pattern->pieceAt(m_pointer->metres) : kNone;
}

void PatternCanvas::toolChanged() {
    setCursor(m_panFrom ? Qt::ClosedHandCursor : m_hasSpace ? Qt::OpenHandCursor : m_tool->cursor());
    emit hintChanged(m_tool->hint());
    update();
}

void PatternCanvas::repaintAll() {
    m_stale = rect();
    update();
}

void PatternCanvas::repaintPart(const Box2& part) {
    if (part.min.x > part.max.x) return;
    const QPointF reach(kAroundChange, kAroundChange);
    const QPointF a = m_state.view.pixels(part.min), b = m_state.view.pixels(part.max);
    m_stale |= QRectF(QRectF(a, b).normalized().topLeft() - reach, QRectF(a, b).normalized().bottomRight() + reach);
    update();
}

void PatternCanvas::updatePicture() {
    const double ratio = devicePixelRatioF();
    const QSize pixels = (QSizeF(size()) * ratio).toSize();
    if (m_picture.size() != pixels || m_picture.devicePixelRatio() != ratio) {
        m_picture = QImage(pixels, QImage::Format_RGB32);
        m_picture.setDevicePixelRatio(ratio);
        m_stale = rect();
    }
    if (m_painted != m_state.view) m_stale = rect();
    m_painted = m_state.view;
    const QRectF part = QRectF(m_stale.toAlignedRect()) & QRectF(rect());
    m_stale = {};
    if (part.isEmpty()) return;
    QPainter painter(&m_picture);
    paintContents(painter, part, m_state.view, m_contents, m_colours);
}

void PatternCanvas::paintEvent(QPaintEvent*) {
    updatePicture();
    QPainter painter(this);
    painter.drawImage(QPointF(0.0, 0.0), m_picture);
    const QString sentence = sentenceInstead();
    paintHovered(painter);
    paintChosen(painter);
    paintOutline(painter);
    m_tool->paint(painter, m_colours);
    if (!sentence.isEmpty()) {
        painter.setPen(m_colours.label);
        painter.drawText(QRectF(rect()).adjusted(40, 40, -40, -40), Qt::AlignCenter | Qt::TextWordWrap, sentence);
    }
    paintRulers(painter, m_state.view, m_colours, m_pointer ? m_pointer->pixels : QPointF(-10.0, -10.0));
}

void PatternCanvas::paintOutline(QPainter& painter) const {
    const Asset* asset = m_state.asset();
    if (!asset) return;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(m_colours.outline, 2.0, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.drawPath(pathOf(asset->prism.outline, m_state.view));
}

void PatternCanvas::paintChosen(QPainter& painter) const {
    if (!m_contents.pattern || m_state.selection.seeds().empty()) return;
    const ShownPattern& pattern = *m_contents.pattern;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(m_colours.accent, 2.0));
    const double radius = std::max(seedRadius(pattern, m_state.view), 2.0) + 2.5;
    for (const SeedId id : m_state.selection.seeds()) {
        const std::uint32_t seed = pattern.find(id);
        if (seed == kNone) continue;
        painter.drawEllipse(m_state.view.pixels(pattern.seeds().positions[seed]), radius, radius);
    }
}

void PatternCanvas::paintHovered(QPainter& painter) const {
    if (m_hovered == kNone || !m_contents.pattern || !m_contents.layers.hasCells) return;
    painter.setRenderHint(QPainter::Antialiasing);
    QColor wash = m_colours.hover;
    wash.setAlpha(24);
    painter.setPen(Qt::NoPen);
    painter.setBrush(wash);
    for (const std::uint32_t neighbour : m_contents.pattern->neighbours(m_hovered)) {
        painter.drawPath(pathOfPiece(*m_contents.pattern, neighbour, m_state.view));
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(m_colours.hover, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(pathOfPiece(*m_contents.pattern, m_hovered, m_state.view));
}

QString PatternCanvas::sentenceInstead() const {
    if (!m_state.asset()) return tr("No asset is at hand. Add one, or choose one in the project tree.");
    if (const auto pattern = m_bakes.findPattern(m_state.selection.asset()); pattern && pattern->fault) {
        return QString::fromStdString(pattern->fault->message);
    }
    return {};
}

CanvasPointer PatternCanvas::pointerAt(QPointF pixels, Qt::KeyboardModifiers modifiers) const {
    return {pixels, m_state.view.metres(pixels), modifiers};
}

void PatternCanvas::point(const CanvasPointer& pointer) {
    m_pointer = pointer;
    m_hovered = m_contents.pattern ? m_contents.pattern->pieceAt(pointer.metres) : kNone;
    emit pointed(pointer.metres.x, pointer.metres.y);
    update();
}

bool PatternCanvas::event(QEvent* event) {
    if (event->type() == QEvent::NativeGesture) {
        const auto* gesture = static_cast<QNativeGestureEvent*>(event);
        if (gesture->gestureType() == Qt::ZoomNativeGesture) {
            setView(zoomed(m_state.view, 1.0 + gesture->value(), gesture->position()));
            return true;
        }
    }
    return QWidget::event(event);
}

void PatternCanvas::resizeEvent(QResizeEvent*) {
    m_state.view.size = size();
    if (m_isFitted) fit();
    repaintAll();
}

void PatternCanvas::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        m_colours = canvasColours(palette());
        repaintAll();
    }
    QWidget::changeEvent(event);
}

void PatternCanvas::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && m_hasSpace)) {
        m_panFrom = event->position();
        return toolChanged();
    }
    if (event->button() == Qt::LeftButton) m_tool->press(pointerAt(event->position(), event->modifiers()));
}

void PatternCanvas::mouseMoveEvent(QMouseEvent* event) {
    if (m_panFrom) {
        setView(panned(m_state.view, event->position() - *m_panFrom));
        m_panFrom = event->position();
    } else {
        m_tool->move(pointerAt(event->position(), event->modifiers()));
    }
    point(pointerAt(event->position(), event->modifiers()));
}

void PatternCanvas::mouseReleaseEvent(QMouseEvent* event) {
    if (m_panFrom && event->button() != Qt::RightButton) {
        m_panFrom.reset();
        return toolChanged();
    }
    if (event->button() == Qt::LeftButton) m_tool->release(pointerAt(event->position(), event->modifiers()));
}

void PatternCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || m_hasSpace) return mousePressEvent(event);
    m_tool->doubleClick(pointerAt(event->position(), event->modifiers()));
}

void PatternCanvas::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / kAnglePerNotch;
    setView(zoomed(m_state.view, std::pow(kZoomPerNotch, notches), event->position()));
    point(pointerAt(event->position(), event->modifiers()));
    event->accept();
}

void PatternCanvas::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
        m_hasSpace = true;
        return toolChanged();
    }
    if (m_tool->key(*event)) return;
    if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal) return zoomBy(kZoomPerNotch);
    if (event->key() == Qt::Key_Minus) return zoomBy(1.0 / kZoomPerNotch);
    QWidget::keyPressEvent(event);
}

void PatternCanvas::keyReleaseEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Space || event->isAutoRepeat()) return QWidget::keyReleaseEvent(event);
    m_hasSpace = false;
    toolChanged();
}

void PatternCanvas::leaveEvent(QEvent*) {
    m_pointer.reset();
    m_hovered = kNone;
    emit pointerLeft();
    update();
}

void PatternCanvas::contextMenuEvent(QContextMenuEvent* event) {
    QMenu menu(this);
    m_tool->fillMenu(menu, pointerAt(event->pos(), event->modifiers()));
    menu.exec(event->globalPos());
}

}  // namespace rubble
