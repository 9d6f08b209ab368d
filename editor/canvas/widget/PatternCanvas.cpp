#include "editor/canvas/widget/PatternCanvas.h"

#include "editor/canvas/painting/BondMarkPainting.h"
#include "editor/canvas/painting/HighlightPainting.h"
#include "editor/canvas/painting/LegendPainting.h"
#include "editor/canvas/painting/RulerPainting.h"
#include "editor/canvas/tools/CrackLineTool.h"
#include "editor/canvas/tools/OutlineTool.h"
#include "editor/canvas/tools/SeedTool.h"
#include "editor/canvas/widget/AccessibleCanvas.h"
#include "editor/canvas/widget/Breadcrumb.h"
#include "editor/canvas/widget/CanvasFraming.h"
#include "editor/canvas/widget/SectionBar.h"
#include "editor/commands/AssetPatterns.h"
#include "editor/document/EnteredFragment.h"
#include "editor/document/ShownText.h"
#include "editor/widgets/Action.h"

#include <QContextMenuEvent>
#include <QNativeGestureEvent>
#include <QScopedValueRollback>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace rubble {

namespace {

constexpr double kZoomPerNotch = 1.2;
constexpr double kAnglePerNotch = 120.0;  // of QWheelEvent::angleDelta()
constexpr int kBreadcrumbGap = 8;         // pixels between rulers and breadcrumb

}  // namespace

PatternCanvas::PatternCanvas(Document& document, Selection& selection, const Bakes& bakes, BondPainter& bondPainter,
                             QWidget* parent)
    : QWidget(parent),
      m_state{.document = document, .selection = selection, .bakes = bakes, .bondPainter = bondPainter},
      m_updater(m_state),
      m_breadcrumb(new Breadcrumb(this)),
      m_colours(canvasColours(palette())),
      m_tools(m_state),
      m_tool(&m_tools.seeds()) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    QAccessible::installFactory(makeAccessible);
    setAccessibleName(tr("Pattern canvas"));
    setAccessibleDescription(tr("The outline of the active asset, its seeds and their cells."));
    connect(&document, &Document::changed, this, &PatternCanvas::applyChanges);
    connect(&selection, &Selection::assetChanged, this, [this] {
        m_savedViews.clear();
        m_displayedFragment = m_state.selection.enteredFragment();
        refreshAsset();
    });
    connect(&selection, &Selection::enteredFragmentChanged, this, &PatternCanvas::refreshEnteredFragment);
    connect(m_breadcrumb, &Breadcrumb::clicked, this,
            [this](const FragmentPath& fragment) { exitToFragment(m_state.selection, fragment); });
    m_breadcrumb->move(static_cast<int>(kRulerWidth) + kBreadcrumbGap, static_cast<int>(kRulerWidth) + kBreadcrumbGap);
    connect(&selection, &Selection::seedsChanged, this, [this] {
        updateTool();
        reportAccessible(QAccessible::SelectionWithin);
    });
    connect(&selection, &Selection::hiddenChanged, this, [this] {
        m_updater.refreshHidden();
        update();
    });
    connect(&bakes, &Bakes::patternChanged, this, [this](Id asset) {
        if (asset != m_state.selection.asset()) return;
        if (m_state.isMesh()) refreshFragment();
        m_updater.refreshPattern();
        m_state.pattern = contents().pattern;
        if (std::exchange(m_isPatternAwaited, false)) m_state.isMesh() ? fit() : refit();  // edits do not move the view
        updateHovered();
        update();
        reportAccessible(QAccessible::ObjectReorder);
    });
    connect(&bakes, &Bakes::changed, this, [this](Id asset) {
        if (asset != m_state.selection.asset()) return;
        refreshFragment();
        m_updater.refreshFragments();
        update();
    });
    for (CanvasTool* tool : m_tools.all()) {
        connect(tool, &CanvasTool::changed, this, &PatternCanvas::updateTool);
        connect(tool, &CanvasTool::statusMessage, this, &PatternCanvas::statusMessage);
    }
    refreshAsset();
}

PatternCanvas::~PatternCanvas() = default;

void PatternCanvas::setSections(Sections& sections) {
    m_sectionBar = new SectionBar(sections, this);
    m_sectionBar->setUnits(m_state.units);
    refreshSectionBar();
}

void PatternCanvas::refreshSectionBar() {
    if (!m_sectionBar) return;
    m_sectionBar->setAsset(m_state.isMesh() ? m_state.asset() : nullptr);
    m_sectionBar->placeBelow(m_breadcrumb->isVisible() ? m_breadcrumb->geometry().bottom() : kRulerWidth);
}

QAccessibleInterface* PatternCanvas::makeAccessible(const QString& /*className*/, QObject* object) {
    auto* canvas = qobject_cast<PatternCanvas*>(object);
    return canvas ? new AccessibleCanvas(*canvas, canvas->m_state) : nullptr;
}

/// Tells assistive technologies of a change; `event` is a QAccessible::Event.
void PatternCanvas::reportAccessible(int event) {
    QAccessibleEvent change(this, static_cast<QAccessible::Event>(event));
    QAccessible::updateAccessibility(&change);
}

void PatternCanvas::setTool(CanvasToolKind kind) {
    if (kind == m_toolKind) return;
    m_tool->cancel();
    m_toolKind = kind;
    m_tool = &m_tools.prepare(kind);
    updateTool();
    refit();
    emit toolKindChanged(kind);
}

void PatternCanvas::setOverlays(const CanvasOverlays& overlays) {
    if (overlays == this->overlays()) return;
    m_updater.setOverlays(overlays);
    refit();
    update();
    emit overlaysChanged();
}

void PatternCanvas::setUnits(const Units& units) {
    m_state.units = units;
    m_updater.setUnits(units);
    if (m_sectionBar) m_sectionBar->setUnits(units);
    update();
}

void PatternCanvas::setView(const CanvasView& view) {
    m_isFitted = false;
    m_state.view = view;
    m_state.view.size = size();
    update();
}

void PatternCanvas::fit() {
    m_isFitted = true;
    const Asset* shown = m_state.displayedAsset();
    if (!shown) return;
    m_state.view.size = size();
    const bool hasBar = m_sectionBar && m_sectionBar->isVisibleTo(this);
    m_state.view = fittedBelow(m_state.view, boundsOf(shown->prism().outline.outer), legendArea(),
                               hasBar ? m_sectionBar->geometry().bottom() - kRulerWidth : 0.0);
    updatePointer();
    update();
}

/// Fits the asset again if it now lies below the legend.
void PatternCanvas::refit() {
    const Asset* shown = m_state.displayedAsset();
    if (!shown || !m_isFitted || m_isPressed) return;
    if (isCovered(m_state.view, boundsOf(shown->prism().outline.outer), legendArea())) fit();
}

QRectF PatternCanvas::legendArea() const {
    if (!contents().overlays.hasLegend) return {};
    return rubble::legendArea(font(), m_state.view, contents(), m_colours);
}

void PatternCanvas::frameSelected(std::optional<Vec2> point) {
    if (!m_state.displayedAsset()) return;
    Box2 box;
    if (point) box.include(*point);
    for (const SeedId id : m_state.selection.seeds()) {
        const auto [shown, seed] = contents().pattern ? contents().find(id) : std::pair{nullptr, kNone};
        if (seed != kNone) include(box, shown->boxOf(seed));
    }
    if (box.min.x > box.max.x) return fit();
    setView(framed(m_state.view, box, boundsOf(m_state.displayedAsset()->prism().outline.outer)));
}

void PatternCanvas::setCompared(std::shared_ptr<const ComparedAsset> compared) {
    m_updater.setCompared(std::move(compared));
    refit();
    update();
}

void PatternCanvas::zoomBy(double factor) { setView(zoomed(m_state.view, factor, rect().center())); }

QString PatternCanvas::hint() const { return m_tool->hint(); }

void PatternCanvas::applyChanges(const Changes& changes) {
    const bool isOfAsset = changes.touches(Part::Asset, m_state.selection.asset());
    if (isOfAsset) refreshFragment();
    if (changes.isUndoOrRedo || (isOfAsset && !m_state.isPushing)) m_tool->endDrag();
    m_updater.refreshMaterial();
    update();
    if (!isOfAsset) return;
    if (!m_state.asset()) refreshAsset();
    m_updater.refreshMovedPart();
    m_updater.refreshBonds();
    reportOwnPattern(changes);
}

void PatternCanvas::refreshAsset() {
    m_tool->cancel();
    refreshFragment();
    m_updater.refreshAll();
    m_state.pattern = contents().pattern;
    updateHovered();
    m_isPatternAwaited = !contents().pattern;
    fit();
    update();
    reportAccessible(QAccessible::ObjectReorder);
}

/// Ends a drag without a change: an undo may have exited the fragment.
void PatternCanvas::refreshEnteredFragment() {
    saveView();
    refreshFragment();
    m_tool->endDrag();
    refreshAsset();
    const auto kept = std::ranges::find(m_savedViews, m_displayedFragment, &SavedView::fragment);
    if (kept != m_savedViews.end()) {
        if (!kept->isFitted) setView(kept->view);
        m_savedViews.erase(kept, m_savedViews.end());
        updatePointer();
    }
    m_hasOwnPattern = m_state.displayedAsset() && m_state.isInFragment() &&
                      hasOwnPattern(*m_state.asset(), m_state.selection.enteredFragment());
}

/// Saves the view of the fragment that is left, to restore it on return.
void PatternCanvas::saveView() {
    const FragmentPath previous = std::exchange(m_displayedFragment, m_state.selection.enteredFragment());
    if (previous != m_displayedFragment) m_savedViews.push_back({previous, m_state.view, m_isFitted});
}

void PatternCanvas::refreshFragment() {
    const Asset* asset = m_state.asset();
    m_state.refreshFragment();
    m_breadcrumb->setPath(asset ? nameText(asset->name) : QString(), m_state.selection.enteredFragment());
    refreshSectionBar();
}

/// Reports when the first edit inside a fragment gives it a pattern of its own.
void PatternCanvas::reportOwnPattern(const Changes& changes) {
    const FragmentPath& entered = m_state.selection.enteredFragment();
    const bool hasOwn = m_state.displayedAsset() && m_state.isInFragment() && hasOwnPattern(*m_state.asset(), entered);
    const bool hadOwn = std::exchange(m_hasOwnPattern, hasOwn);
    if (!hasOwn || hadOwn || changes.isUndoOrRedo) return;
    emit statusMessage(tr("Fragment %1 now has its own pattern. The other fragments of its level keep theirs.")
                           .arg(nameText(entered)));
}

void PatternCanvas::updateTool() {
    m_updater.refreshBonds();
    setCursor(m_panFrom ? Qt::ClosedHandCursor : m_isSpaceHeld ? Qt::OpenHandCursor : m_tool->cursor());
    emit hintChanged(m_tool->hint());
    update();
}

void PatternCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.drawImage(QPointF(0.0, 0.0), m_updater.image(devicePixelRatioF(), m_colours));
    paintOverlays(painter);
}

QImage PatternCanvas::picture(QSize pixels) {
    const double ratio = std::min(static_cast<double>(pixels.width()) / std::max(1, width()),
                                  static_cast<double>(pixels.height()) / std::max(1, height()));
    m_tool->leave();
    const QScopedValueRollback view(m_state.view);
    const QScopedValueRollback pointer(m_pointer, std::optional<CanvasPointer>());
    const QScopedValueRollback hovered(m_hovered, kNone);
    m_state.view.size = QSizeF(pixels) / ratio;
    QImage image(pixels, QImage::Format_RGB32);
    image.setDevicePixelRatio(ratio);
    QPainter painter(&image);
    CanvasBackingStore store;
    painter.drawImage(QPointF(0.0, 0.0), store.at(m_state.view, ratio, contents(), m_colours));
    paintOverlays(painter);
    if (m_breadcrumb->isVisible()) m_breadcrumb->render(&painter, m_breadcrumb->pos());
    return image;
}

/// Paints what is above the contents.
void PatternCanvas::paintOverlays(QPainter& painter) const {
    paintBondMarks(painter, m_state.view, contents(), m_colours);
    paintHighlights(painter);
    std::array<QRectF, 2> panels;
    if (contents().overlays.hasLegend) panels[0] = paintLegend(painter, m_state.view, contents(), m_colours);
    if (m_breadcrumb->isVisible()) panels[1] = m_breadcrumb->geometry();
    m_tool->paint(painter, m_colours);  // above the legend, so that no error message is hidden
    if (showsFragmentLabel()) {
        paintFragmentLabel(painter, contents(), m_hovered, m_pointer->pixels, panels, m_state.view, m_colours);
    }
    if (const QString message = m_state.placeholder(); !message.isEmpty() && !m_tools.outline().isDrawing()) {
        paintMessage(painter, message, m_state.view, m_colours,
                     m_state.asset() ? m_colours.fault : m_colours.panelEdge);
    }
    if (m_tool->isPrompting()) {
        const double top = m_breadcrumb->isVisible() ? m_breadcrumb->geometry().bottom() : kRulerWidth;
        paintPrompt(painter, m_tool->hint(), top, m_pointer ? m_pointer->pixels : rect().center(), m_state.view,
                    m_colours);
    }
    paintRulers(painter, m_state.view, m_state.units, m_colours, m_pointer ? m_pointer->pixels : QPointF(-10.0, -10.0));
}

void PatternCanvas::paintHighlights(QPainter& painter) const {
    const bool hasPiece = contents().pattern && contents().overlays.hasCells && m_hovered != kNone;
    if (hasPiece && !m_isPressed) paintHovered(painter, *contents().pattern, m_hovered, m_state.view, m_colours);
    if (const Asset* shown = m_state.displayedAsset())
        paintOutline(painter, shown->prism().outline, m_state.view, m_colours);
    if (contents().pattern) {
        for (const Polygon& outline : contents().pattern->baked().otherOutlines)
            paintOutline(painter, outline, m_state.view, m_colours);
    }
    if (contents().pattern && contents().overlays.hasTriangles && m_pointer) {
        paintTriangleAt(painter, m_pointer->metres, m_state.view, contents(), m_colours);
    }
    paintSelection(painter, m_state.selection, m_state.view, contents(), m_colours);
}

/// Whether to label the hovered piece: not while drawing, measuring or dragging.
bool PatternCanvas::showsFragmentLabel() const {
    if (m_hovered == kNone || !contents().pattern || !m_pointer || !contents().overlays.hasCells) return false;
    return m_toolKind != CanvasToolKind::Measure && !isBrush(m_toolKind) && !m_tools.outline().isDrawing() &&
           !m_tools.crackLines().isDrawing() && !m_panFrom && !m_isPressed;
}

CanvasPointer PatternCanvas::pointerAt(QPointF pixels, Qt::KeyboardModifiers modifiers) const {
    return {pixels, m_state.view.metres(pixels), modifiers};
}

/// Finds the piece under the pointer.
void PatternCanvas::updateHovered() {
    m_hovered = m_pointer && contents().pattern ? contents().pattern->pieceAt(m_pointer->metres) : kNone;
}

void PatternCanvas::setPointer(const CanvasPointer& pointer) {
    m_pointer = pointer;
    updateHovered();
    emit pointerMoved(pointer.metres.x, pointer.metres.y);
    update();
}

/// Updates what is under the pointer after the view moved.
void PatternCanvas::updatePointer() {
    if (m_pointer) setPointer(pointerAt(m_pointer->pixels, m_pointer->modifiers));
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
        if (key->modifiers() == Qt::NoModifier && m_tool->overridesShortcut(key->key())) {
            event->accept();
            return true;
        }
    }
    if (handleShortcut(m_precedingActions, *event)) return true;
    return QWidget::event(event);
}

void PatternCanvas::resizeEvent(QResizeEvent*) {
    m_state.view.size = size();
    if (m_isFitted) fit();
    refreshSectionBar();
    m_updater.invalidateAll();
    update();
}

void PatternCanvas::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        m_colours = canvasColours(palette());
        m_updater.invalidateAll();
        update();
    }
    QWidget::changeEvent(event);
}

void PatternCanvas::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && m_isSpaceHeld)) {
        m_panFrom = event->position();
        m_panButton = event->button();
        return updateTool();
    }
    if (event->button() != Qt::LeftButton) return;
    m_isPressed = true;
    m_tool->press(pointerAt(event->position(), event->modifiers()));
}

void PatternCanvas::mouseMoveEvent(QMouseEvent* event) {
    endMissedRelease(*event);
    if (m_panFrom) {
        setView(panned(m_state.view, event->position() - *m_panFrom));
        m_panFrom = event->position();
    } else {
        m_tool->move(pointerAt(event->position(), event->modifiers()));
    }
    setPointer(pointerAt(event->position(), event->modifiers()));
}

/// Ends what a button began whose release went elsewhere, to a dialog for example.
void PatternCanvas::endMissedRelease(const QMouseEvent& event) {
    if (m_panFrom && !event.buttons().testFlag(m_panButton)) m_panFrom.reset();
    if (m_isPressed && !event.buttons().testFlag(Qt::LeftButton))
        release(pointerAt(event.position(), event.modifiers()));
}

void PatternCanvas::mouseReleaseEvent(QMouseEvent* event) {
    if (m_panFrom && event->button() == m_panButton) {
        m_panFrom.reset();
        return updateTool();
    }
    if (event->button() == Qt::LeftButton) release(pointerAt(event->position(), event->modifiers()));
}

void PatternCanvas::release(const CanvasPointer& pointer) {
    m_isPressed = false;
    m_tool->release(pointer);
}

void PatternCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || m_isSpaceHeld) return mousePressEvent(event);
    m_isPressed = true;
    m_tool->doubleClick(pointerAt(event->position(), event->modifiers()));
}

void PatternCanvas::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / kAnglePerNotch;
    event->accept();
    if (event->modifiers().testFlag(Qt::ControlModifier) && m_tool->controlWheel(notches)) return;
    setView(zoomed(m_state.view, std::pow(kZoomPerNotch, notches), event->position()));
    setPointer(pointerAt(event->position(), event->modifiers()));
}

void PatternCanvas::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
        m_isSpaceHeld = true;
        return updateTool();
    }
    if (event->key() == Qt::Key_Escape && contents().compared && !m_tool->cancel()) return emit comparisonDismissed();
    if (m_tool->key(*event)) return;
    if (event->key() == Qt::Key_Escape && m_state.isInFragment())
        return exitToFragment(m_state.selection, parentOf(m_state.selection.enteredFragment()));
    if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal) return zoomBy(kZoomPerNotch);
    if (event->key() == Qt::Key_Minus) return zoomBy(1.0 / kZoomPerNotch);
    QWidget::keyPressEvent(event);
}

void PatternCanvas::keyReleaseEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Space || event->isAutoRepeat()) return QWidget::keyReleaseEvent(event);
    m_isSpaceHeld = false;
    updateTool();
}

void PatternCanvas::focusOutEvent(QFocusEvent* event) {
    m_isSpaceHeld = false;
    m_panFrom.reset();
    updateTool();
    QWidget::focusOutEvent(event);
}

void PatternCanvas::leaveEvent(QEvent*) {
    m_pointer.reset();
    m_hovered = kNone;
    m_tool->leave();
    emit pointerLeft();
    update();
}

/// There is no menu during a drag: it would take the release of the button.
void PatternCanvas::contextMenuEvent(QContextMenuEvent* event) {
    if (m_isPressed) return;
    QMenu menu(this);
    const CanvasPointer pointer = pointerAt(event->pos(), event->modifiers());
    m_tool->fillMenu(menu, pointer);
    addFragmentNavigation(menu, m_state, pointer.metres);
    menu.addSeparator();
    if (!m_state.selection.fragments().isEmpty()) menu.addActions(m_fragmentActions);
    menu.exec(event->globalPos());
}

}  // namespace rubble

#include "moc_PatternCanvas.cpp"
