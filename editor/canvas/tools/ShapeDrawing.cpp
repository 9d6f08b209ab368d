#include "editor/canvas/tools/ShapeDrawing.h"

#include "core/asset/project/OutlineEdit.h"
#include "core/base/Assert.h"
#include "core/geometry/polygon/PolygonFaults.h"
#include "editor/canvas/tools/Snapping.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/document/EnteredFragment.h"

#include <QApplication>

namespace rubble {

namespace {

constexpr double kCloseRadius = 8.0;   // pixels, around the first corner
constexpr double kDefaultDepth = 0.5;  // m, of a new asset

}  // namespace

OutlineDraft& ShapeDrawing::draft() {
    RUBBLE_ASSERT(m_draft);
    return *m_draft;
}

const OutlineDraft& ShapeDrawing::draft() const {
    RUBBLE_ASSERT(m_draft);
    return *m_draft;
}

void ShapeDrawing::begin(Purpose purpose, DraftShape shape) {
    cancel();
    if (purpose == Purpose::NewAsset) exitToFragment(m_state.selection, {});
    if (purpose != Purpose::NewAsset && (!m_state.asset() || m_state.isInFragment())) return;
    if (purpose != Purpose::NewAsset && m_state.isMesh()) {
        emit statusMessage(tr("Only prisms have an outline to draw; this asset is a mesh."));
        return;
    }
    m_purpose = purpose;
    m_fault.clear();
    m_draft.emplace(shape).movePen(m_state.view.centre);
    emit changed();
}

void ShapeDrawing::press(const CanvasPointer& pointer) {
    m_pressed = pointer.pixels;
    m_fault.clear();
    draft().movePen(snapped(m_state, pointer, outlineTargets(m_state)));
    if (draft().closesAt(kCloseRadius / m_state.view.scale)) return close();
    add();
}

/// Adds a point at the pen; the last one of a rectangle or a circle closes it.
void ShapeDrawing::add() {
    draft().add();
    if (draft().isComplete()) close();
    emit changed();
}

void ShapeDrawing::move(const CanvasPointer& pointer) {
    draft().movePen(snapped(m_state, pointer, outlineTargets(m_state)));
    emit changed();
}

/// A rectangle or a circle can also be dragged from its first point to the second.
void ShapeDrawing::release(const CanvasPointer& pointer) {
    if (draft().shape() == DraftShape::Polygon || draft().points().empty()) return;
    if ((pointer.pixels - m_pressed).manhattanLength() >= QApplication::startDragDistance()) add();
}

void ShapeDrawing::doubleClick(const CanvasPointer& pointer) {
    if (draft().shape() == DraftShape::Polygon) return close();
    press(pointer);
}

void ShapeDrawing::close() {
    const Polygon drawn{draft().ring(), {}};
    const auto outline = [&] { return m_state.asset()->prism().outline; };
    bool isDone = false;
    switch (m_purpose) {
        case Purpose::Replace: isDone = pushOutline(tr("Draw Outline"), validated(drawn)); break;
        case Purpose::NewAsset: isDone = pushNewAsset(); break;
        case Purpose::Add:
            isDone = pushOutline(tr("Add to Outline"), combined(outline(), drawn.outer, OutlineOperation::Add));
            break;
        case Purpose::Cut:
            isDone = pushOutline(tr("Cut from Outline"), combined(outline(), drawn.outer, OutlineOperation::Cut));
            break;
    }
    if (isDone) {
        m_draft.reset();
    } else if (draft().isComplete()) {
        draft().removeLast();
    }
    emit changed();
}

bool ShapeDrawing::refuse(const Error& error) {
    m_fault = QString::fromStdString(error.message);
    emit statusMessage(m_fault);
    return false;
}

bool ShapeDrawing::pushNewAsset() {
    const Result<Polygon> outline = validated(Polygon{draft().ring(), {}});
    if (!outline) return refuse(outline.error());
    Addition addition = addAsset(m_state.document.project(), tr("shape").toStdString(), {*outline, kDefaultDepth});
    if (!m_state.push(std::move(addition.edit))) return false;
    m_state.selection.setAsset(addition.id);
    return true;
}

bool ShapeDrawing::pushOutline(const QString& text, const Result<Polygon>& outline) {
    if (!outline) return refuse(outline.error());
    return m_state.push(modify(text, withOutline(*m_state.asset(), *outline)));
}

bool ShapeDrawing::cancel() {
    if (!m_draft) return false;
    m_draft.reset();
    emit changed();
    return true;
}

bool ShapeDrawing::key(const QKeyEvent& event) {
    m_fault.clear();
    if (const std::optional<Vec2> by = nudgeStep(event, m_state)) {
        draft().movePen(draft().pen() + *by);
        emit changed();
        return true;
    }
    switch (event.key()) {
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (draft().shape() == DraftShape::Polygon) {
                close();
            } else {
                add();
            }
            return true;
        case Qt::Key_Backspace:
        case Qt::Key_Delete:
            if (!draft().removeLast()) cancel();
            emit changed();
            return true;
        case Qt::Key_Insert: add(); return true;
        default: return CanvasTool::key(event);
    }
}

void ShapeDrawing::paint(QPainter& painter, const CanvasColours& colours) const {
    draft().paint(painter, m_state.view, colours);
}

QString ShapeDrawing::hint() const { return m_fault.isEmpty() ? nextStep() : m_fault + ' ' + nextStep(); }

QString ShapeDrawing::nextStep() const {
    const std::size_t count = draft().points().size();
    switch (draft().shape()) {
        case DraftShape::Polygon:
            if (count == 0) return tr("Click the first corner · Esc: cancel");
            if (count < 3) return tr("Click the next corner · Backspace: remove the last one · Esc: cancel");
            return tr(
                "Click the next corner · Enter or a click on the first corner closes the shape · "
                "Backspace: remove the last one · Esc: cancel");
        case DraftShape::Rectangle:
            return count == 0 ? tr("Click a corner of the rectangle, or drag it · Esc: cancel")
                              : tr("Click the opposite corner · Shift: no snapping · Esc: cancel");
        case DraftShape::Circle:
            return count == 0 ? tr("Click the centre of the circle, or drag from it · Esc: cancel")
                              : tr("Click a point on the circle · Shift: no snapping · Esc: cancel");
    }
    return {};
}

void ShapeDrawing::fillMenu(QMenu& menu, const CanvasPointer&) {
    QAction* close = menu.addAction(tr("&Close Shape"), this, &ShapeDrawing::close);
    close->setEnabled(draft().shape() == DraftShape::Polygon && draft().points().size() > 2);
    menu.addAction(tr("C&ancel"), this, &ShapeDrawing::cancel);
}

}  // namespace rubble

#include "moc_ShapeDrawing.cpp"
