#include "editor/canvas/PatternCanvas.h"

#include "core/asset/FragmentPlace.h"
#include "core/asset/Threshold.h"
#include "editor/canvas/BrushTool.h"
#include "editor/canvas/GridPainting.h"
#include "editor/canvas/LegendPainting.h"
#include "editor/canvas/MarkPainting.h"
#include "editor/canvas/MeasureTool.h"
#include "editor/canvas/OutlineTool.h"
#include "editor/canvas/PlaceTrail.h"
#include "editor/canvas/SeedTool.h"
#include "editor/canvas/StrokeTool.h"
#include "editor/canvas/SurroundingEdges.h"
#include "editor/commands/PatternPlaces.h"
#include "editor/document/Inside.h"

#include <QContextMenuEvent>
#include <QNativeGestureEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rubble {

namespace {

constexpr double kMargin = 24.0;  // pixels around what is fitted
constexpr double kZoomPerNotch = 1.2;
constexpr double kAnglePerNotch = 120.0;  // as Qt counts a wheel's turning
constexpr double kAroundChosen = 0.75;    // of its size, that is shown around what is chosen
constexpr double kLeastFramed = 0.02;     // of the outline, that is shown at least
constexpr int kTrailGap = 8;              // pixels between the rulers and what tells where one is

}  // namespace

PatternCanvas::PatternCanvas(Document& document, Selection& selection, const Bakes& bakes, QWidget* parent)
    : QWidget(parent),
      m_state{.document = document, .selection = selection, .bakes = bakes},
      m_trail(new PlaceTrail(this)),
      m_colours(canvasColours(palette())),
      m_outlineTool(std::make_unique<OutlineTool>(m_state)),
      m_seedTool(std::make_unique<SeedTool>(m_state)),
      m_strokeTool(std::make_unique<StrokeTool>(m_state)),
      m_brushTool(std::make_unique<BrushTool>(m_state)),
      m_measureTool(std::make_unique<MeasureTool>(m_state)),
      m_tool(m_seedTool.get()) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(tr("Pattern canvas"));
    setAccessibleDescription(tr("The outline of the asset at hand, its seeds and the cells they make."));
    connect(&document, &Document::changed, this, &PatternCanvas::takeChanges);
    connect(&selection, &Selection::assetChanged, this, [this] {
        m_keptViews.clear();
        m_place = m_state.selection.inside();
        takeAsset();
    });
    connect(&selection, &Selection::insideChanged, this, &PatternCanvas::takeInside);
    connect(m_trail, &PlaceTrail::chosen, this, [this](const FragmentPath& place) { goOut(m_state.selection, place); });
    m_trail->move(static_cast<int>(kRulerWidth) + kTrailGap, static_cast<int>(kRulerWidth) + kTrailGap);
    connect(&selection, &Selection::seedsChanged, this, &PatternCanvas::toolChanged);
    connect(&selection, &Selection::hiddenChanged, this, [this] {
        m_contents.hidden = m_state.selection.hidden();
        repaintAll();
    });
    connect(&bakes, &Bakes::patternChanged, this, [this](Id asset) {
        if (asset == m_state.selection.asset()) takePattern();
    });
    connect(&bakes, &Bakes::changed, this, [this](Id asset) {
        if (asset != m_state.selection.asset()) return;
        takeFragment();
        takeSurroundings();
        if (m_contents.layers.colouring == CellColouring::Level) takeBake();
    });
    for (CanvasTool* tool : std::initializer_list<CanvasTool*>{
             m_outlineTool.get(), m_seedTool.get(), m_strokeTool.get(), m_brushTool.get(), m_measureTool.get()}) {
        connect(tool, &CanvasTool::changed, this, &PatternCanvas::toolChanged);
        connect(tool, &CanvasTool::said, this, &PatternCanvas::said);
    }
    takeAsset();
}

PatternCanvas::~PatternCanvas() = default;

void PatternCanvas::setTool(CanvasToolKind kind) {
    if (kind == m_toolKind) return;
    m_tool->cancel();
    m_toolKind = kind;
    switch (kind) {
        case CanvasToolKind::Outline: m_tool = m_outlineTool.get(); break;
        case CanvasToolKind::Seeds: m_tool = m_seedTool.get(); break;
        case CanvasToolKind::Strokes: m_tool = m_strokeTool.get(); break;
        case CanvasToolKind::Brush: m_tool = m_brushTool.get(); break;
        case CanvasToolKind::Measure: m_tool = m_measureTool.get(); break;
    }
    toolChanged();
    emit toolKindChanged(kind);
}

void PatternCanvas::setLayers(const CanvasLayers& layers) {
    if (layers == m_contents.layers) return;
    m_contents.layers = layers;
    takeBake();
    takeMoves();
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
    const Asset* shown = m_state.shown();
    if (!shown) return;
    // Rulers cover two of the edges.
    CanvasView view = m_state.view;
    view.size = QSizeF(size()) - QSizeF(kRulerWidth, kRulerWidth);
    view = fitted(view, boundsOf(shown->prism.outline.outer), kMargin);
    view.size = size();
    m_state.view = panned(view, {kRulerWidth / 2.0, kRulerWidth / 2.0});
    pointAgain();
    update();
}

void PatternCanvas::frameChosen(std::optional<Vec2> place) {
    if (!m_state.shown()) return;
    Box2 box;
    if (place) box.include(*place);
    for (const SeedId id : m_state.selection.seeds()) {
        const auto [shown, seed] = m_contents.pattern ? m_contents.find(id) : std::pair{nullptr, kNone};
        if (seed != kNone) include(box, shown->boxOf(seed));
    }
    if (box.min.x > box.max.x) return fit();
    // Points have no size, and what is close to nothing else cannot be made out.
    const double least = kLeastFramed * boundsOf(m_state.shown()->prism.outline.outer).diagonal();
    const Vec2 around(std::max(kAroundChosen * box.diagonal(), least));
    setView(fitted(m_state.view, {box.min - around, box.max + around}, kMargin));
}

void PatternCanvas::setCompared(std::shared_ptr<const ComparedAsset> compared) {
    if (compared == m_compared) return;
    m_compared = std::move(compared);
    takeComparison();
    repaintAll();
}

void PatternCanvas::takeComparison() { m_contents.compared = m_state.isInside() ? nullptr : m_compared; }

void PatternCanvas::zoomBy(double factor) { setView(zoomed(m_state.view, factor, rect().center())); }

QString PatternCanvas::hint() const { return m_tool->hint(); }

void PatternCanvas::takeChanges(const Changes& changes) {
    const bool isOfAsset = changes.touches(Part::Asset, m_state.selection.asset());
    if (isOfAsset) takeFragment();
    if (changes.isStepTaken) m_tool->letGo();
    takeMaterial();
    if (!isOfAsset) return;
    if (!m_state.asset()) takeAsset();
    takeMoves();
    tellOfOwnPattern(changes);
    update();
}

void PatternCanvas::takeAsset() {
    m_tool->cancel();
    m_contents.hidden = m_state.selection.hidden();
    takeFragment();
    takeSurroundings();
    takeComparison();
    takeMaterial();
    takePattern();
    takeBake();
    fit();
    repaintAll();
}

/// What is being dragged stays as it is: one may be taken out by an undo.
void PatternCanvas::takeInside() {
    keepView();
    takeFragment();
    m_tool->letGo();
    takeAsset();
    const auto kept = std::ranges::find(m_keptViews, m_place, &KeptView::place);
    if (kept != m_keptViews.end()) {
        if (!kept->isFitted) setView(kept->view);
        m_keptViews.erase(kept, m_keptViews.end());
        pointAgain();
    }
    m_hasOwnPattern =
        m_state.shown() && m_state.isInside() && hasOwnPattern(*m_state.asset(), m_state.selection.inside());
}

/// Whoever comes back to the place that is left sees it as it was left.
void PatternCanvas::keepView() {
    const FragmentPath left = std::exchange(m_place, m_state.selection.inside());
    if (left != m_place) m_keptViews.push_back({left, m_state.view, m_isFitted});
}

/// The fragment that one is inside, as the document has it now.
void PatternCanvas::takeFragment() {
    const Asset* asset = m_state.asset();
    const FragmentPath& inside = m_state.selection.inside();
    m_state.fragment = nullptr;
    if (asset && !inside.empty()) {
        if (std::optional<FragmentSolid> solid = solidOf(m_state.bakes, asset->id, inside))
            m_state.fragment = std::make_shared<const Asset>(asWhole(*asset, inside, std::move(solid->prism)));
    }
    m_trail->setPlace(asset ? QString::fromStdString(asset->name) : QString(), inside);
}

void PatternCanvas::takeSurroundings() {
    if (m_contents.around.empty() && !m_state.isInside()) return;
    const auto baked = m_state.bakes.find(m_state.selection.asset());
    if (baked && !baked->bake && m_state.isInside()) return;  // as it was before the fault
    m_contents.around.clear();
    if (baked && m_state.isInside()) m_contents.around = edgesAround(*baked->bake, m_state.selection.inside());
    repaintAll();
}

/// The first change inside a fragment that was broken as its level says.
void PatternCanvas::tellOfOwnPattern(const Changes& changes) {
    const FragmentPath& inside = m_state.selection.inside();
    const bool hasOwn = m_state.shown() && m_state.isInside() && hasOwnPattern(*m_state.asset(), inside);
    const bool hadOwn = std::exchange(m_hasOwnPattern, hasOwn);
    if (!hasOwn || hadOwn || changes.isStepTaken) return;
    emit said(tr("Fragment %1 has a pattern of its own from now on; the others of its level stay as they are.")
                  .arg(QString::fromStdString(inside)));
}

void PatternCanvas::takePattern() {
    const std::shared_ptr<const BakedPattern> baked =
        m_state.bakes.findPattern(m_state.selection.asset(), m_state.selection.inside());
    const std::shared_ptr<const ShownPattern> before = m_contents.pattern;
    if (before && &before->baked() == baked.get()) return;
    const std::shared_ptr<const MovedPart> movedBefore = m_contents.moved;
    const Asset* shown = m_contents.asset();
    const ShownPattern::Range range = m_contents.range;
    m_contents.pattern = baked && !baked->fault ? std::make_shared<const ShownPattern>(baked) : nullptr;
    m_contents.range = scale();
    m_state.pattern = m_contents.pattern;
    m_movedCells = m_contents.pattern ? std::make_unique<MovedCells>(m_contents.pattern) : nullptr;
    findMoved();
    if (!before || !m_contents.pattern || range != m_contents.range || !isLocal()) {
        repaintAll();
    } else if (*shown != *m_contents.asset()) {  // else it is on the canvas already
        Box2 box = differenceBox(*before, *m_contents.pattern);
        include(box, movedBox(movedBefore.get()));
        include(box, movedBox(m_contents.moved.get()));
        repaintPart(box);
    }
    m_hovered = m_pointer && m_contents.pattern ? m_contents.pattern->pieceAt(m_pointer->metres) : kNone;
}

/// What follows from fragments: through how many levels each that is seen is broken again. Names are made where they are coloured by
/// only.
void PatternCanvas::takeBake() {
    m_contents.depths.clear();
    const auto baked = m_state.bakes.find(m_state.selection.asset());
    if (m_contents.layers.colouring == CellColouring::Level && baked && baked->bake) {
        const Bake& bake = *baked->bake;
        const std::optional<std::uint32_t> inside = fragmentAt(bake, m_state.selection.inside());
        for (const BakedBreaking& breaking : bake.breakings) {
            std::uint32_t parent = breaking.parent;
            while (parent != kNone && bake.fragment(parent).parent != inside) parent = bake.fragment(parent).parent;
            if (parent == kNone) continue;
            int& depth = m_contents.depths[bake.fragmentId(parent)];
            depth = std::max(depth, static_cast<int>(breaking.level - bake.fragment(parent).level));
        }
    }
    m_contents.range = scale();
    repaintAll();
}

void PatternCanvas::takeMaterial() {
    const Asset* asset = m_state.asset();
    const Material* material = asset ? findMaterial(m_state.document.project(), asset->material) : nullptr;
    m_contents.density = material ? material->density : 0.0;
    m_contents.threshold = material ? thresholdOf(*asset, *material) : 0.0;
    update();
}

ShownPattern::Range PatternCanvas::scale() const {
    ShownPattern::Range range;
    if (!m_contents.pattern) return range;
    if (m_contents.layers.colouring != CellColouring::Level) {
        return m_contents.pattern->range(m_contents.layers.colouring);
    }
    for (const auto& [id, depth] : m_contents.depths) range.most = std::max(range.most, static_cast<double>(depth));
    return range;
}

/// Triangles, bonds and the whole diagram reach beyond the cells that change.
bool PatternCanvas::isLocal() const {
    const CanvasLayers& layers = m_contents.layers;
    return !layers.hasTriangles && !layers.hasBonds && !layers.hasWholeVoronoi;
}

void PatternCanvas::findMoved() {
    m_contents.moved = m_movedCells && m_state.shown() && isLocal() ? m_movedCells->partOf(*m_state.shown()) : nullptr;
}

/// Shows what moved since the pattern was baked.
void PatternCanvas::takeMoves() {
    const std::shared_ptr<const MovedPart> before = m_contents.moved;
    findMoved();
    Box2 box = movedBox(before.get());
    include(box, movedBox(m_contents.moved.get()));
    repaintPart(box);
}

/// Around what a moved part paints otherwise: where not its name but a measure colours a piece, all of the piece.
Box2 PatternCanvas::movedBox(const MovedPart* part) const {
    if (!part) return {};
    const CellColouring colouring = m_contents.layers.colouring;
    return colouring == CellColouring::None || colouring == CellColouring::Piece ? part->moved : part->changed;
}

void PatternCanvas::toolChanged() {
    setCursor(m_panFrom ? Qt::ClosedHandCursor : m_hasSpace ? Qt::OpenHandCursor : m_tool->cursor());
    emit hintChanged(m_tool->hint());
    update();
}

void PatternCanvas::repaintAll() {
    m_picture.spoilAll();
    update();
}

void PatternCanvas::repaintPart(const Box2& part) {
    m_picture.spoil(part);
    update();
}

void PatternCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.drawImage(QPointF(0.0, 0.0), m_picture.at(m_state.view, devicePixelRatioF(), m_contents, m_colours));
    paintMarks(painter);
    if (m_contents.layers.hasLegend) paintLegend(painter, m_state.view, m_contents, m_colours);
    m_tool->paint(painter, m_colours);  // over the legend, so that no sentence about a fault is hidden
    if (isTellingOfPiece()) {
        paintPieceLabel(painter, *m_contents.pattern, m_hovered, m_pointer->pixels, m_state.view, m_colours);
    }
    if (const QString sentence = sentenceInstead(); !sentence.isEmpty() && !m_outlineTool->isDrawing()) {
        paintSentence(painter, sentence, m_state.view, m_colours,
                      m_state.asset() ? m_colours.fault : m_colours.panelEdge);
    }
    paintRulers(painter, m_state.view, m_colours, m_pointer ? m_pointer->pixels : QPointF(-10.0, -10.0));
}

void PatternCanvas::paintMarks(QPainter& painter) const {
    const bool hasPiece = m_contents.pattern && m_contents.layers.hasCells && m_hovered != kNone;
    if (hasPiece && !m_isPressed) paintHovered(painter, *m_contents.pattern, m_hovered, m_state.view, m_colours);
    if (const Asset* shown = m_state.shown()) paintOutline(painter, shown->prism.outline, m_state.view, m_colours);
    if (m_contents.pattern && m_contents.layers.hasTriangles && m_pointer) {
        paintTriangleAt(painter, m_pointer->metres, m_state.view, m_contents, m_colours);
    }
    paintChosen(painter, m_state.selection, m_state.view, m_contents, m_colours);
}

/// Whether the piece at the pointer is what one looks at: nothing is being drawn, measured or moved.
bool PatternCanvas::isTellingOfPiece() const {
    if (m_hovered == kNone || !m_contents.pattern || !m_pointer || !m_contents.layers.hasCells) return false;
    return m_toolKind != CanvasToolKind::Measure && m_toolKind != CanvasToolKind::Brush &&
           !m_outlineTool->isDrawing() && !m_strokeTool->isDrawing() && !m_panFrom && !m_isPressed;
}

QString PatternCanvas::sentenceInstead() const {
    if (!m_state.asset()) {  // what to begin with is told by the window where there is none at all
        return m_state.document.project().assets.empty()
                   ? QString()
                   : tr("No asset is at hand. Choose one in the project tree, or add one.");
    }
    const auto pattern = m_state.bakes.findPattern(m_state.selection.asset(), m_state.selection.inside());
    if (pattern && pattern->fault) return QString::fromStdString(pattern->fault->message);
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

/// The pointer stays, and what is under it does not.
void PatternCanvas::pointAgain() {
    if (m_pointer) point(pointerAt(m_pointer->pixels, m_pointer->modifiers));
}

bool PatternCanvas::event(QEvent* event) {
    if (event->type() == QEvent::NativeGesture) {
        const auto* gesture = static_cast<QNativeGestureEvent*>(event);
        if (gesture->gestureType() == Qt::ZoomNativeGesture) {
            setView(zoomed(m_state.view, 1.0 + gesture->value(), gesture->position()));
            return true;
        }
    }
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->modifiers() == Qt::NoModifier && m_tool->ownsKey(key->key())) {
            event->accept();
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
    if (event->button() != Qt::LeftButton) return;
    m_isPressed = true;
    m_tool->press(pointerAt(event->position(), event->modifiers()));
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
    if (event->button() != Qt::LeftButton) return;
    m_isPressed = false;
    m_tool->release(pointerAt(event->position(), event->modifiers()));
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
    if (event->key() == Qt::Key_Escape && m_contents.compared && !m_tool->cancel()) return emit comparisonDismissed();
    if (m_tool->key(*event)) return;
    if (event->key() == Qt::Key_Escape && m_state.isInside())
        return goOut(m_state.selection, parentOf(m_state.selection.inside()));
    if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal) return zoomBy(kZoomPerNotch);
    if (event->key() == Qt::Key_Minus) return zoomBy(1.0 / kZoomPerNotch);
    QWidget::keyPressEvent(event);
}

void PatternCanvas::keyReleaseEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Space || event->isAutoRepeat()) return QWidget::keyReleaseEvent(event);
    m_hasSpace = false;
    toolChanged();
}

void PatternCanvas::focusOutEvent(QFocusEvent* event) {
    m_hasSpace = false;
    m_panFrom.reset();
    toolChanged();
    QWidget::focusOutEvent(event);
}

void PatternCanvas::leaveEvent(QEvent*) {
    m_pointer.reset();
    m_hovered = kNone;
    emit pointerLeft();
    update();
}

void PatternCanvas::addPlaces(QMenu& menu, const std::optional<FragmentPath>& broken) {
    if (!broken && !m_state.isInside()) return;
    menu.addSeparator();
    if (broken) {
        menu.addAction(tr("&Go Into Fragment %1").arg(QString::fromStdString(*broken)), this,
                       [this, broken] { goInto(m_state.selection, *broken); });
    }
    if (m_state.isInside()) {
        menu.addAction(tr("Go &Out"), this, [this] { goOut(m_state.selection, parentOf(m_state.selection.inside())); });
    }
}

void PatternCanvas::contextMenuEvent(QContextMenuEvent* event) {
    QMenu menu(this);
    const CanvasPointer pointer = pointerAt(event->pos(), event->modifiers());
    m_tool->fillMenu(menu, pointer);
    addPlaces(menu, m_state.brokenAt(pointer.metres));
    menu.addSeparator();
    if (!m_state.selection.choice().isEmpty()) menu.addActions(m_pieceActions);
    menu.exec(event->globalPos());
}

}  // namespace rubble
