#include "editor/canvas/widget/AccessibleCanvas.h"

#include "editor/canvas/tools/PieceSelection.h"
#include "editor/document/ShownText.h"

#include <QCoreApplication>

namespace rubble {

namespace {

constexpr double kFarAway = 1e6;  // pixels; at the largest scales, rectangles would not fit into whole numbers

struct AccessibleCanvasTexts {
    Q_DECLARE_TR_FUNCTIONS(rubble::AccessibleCanvas)
};

/// A fragment of a pattern. It is invalid once the canvas shows another pattern.
class AccessibleFragment : public QAccessibleInterface, public QAccessibleActionInterface {
public:
    AccessibleFragment(QWidget& canvas, const CanvasState& state, std::uint32_t piece)
        : m_canvas(canvas), m_state(state), m_pattern(state.pattern), m_piece(piece) {}

    std::uint32_t piece() const { return m_piece; }

    bool isValid() const override { return m_state.pattern && m_pattern.lock() == m_state.pattern; }
    QObject* object() const override { return nullptr; }
    QWindow* window() const override { return m_canvas.window()->windowHandle(); }
    QAccessibleInterface* parent() const override { return QAccessible::queryAccessibleInterface(&m_canvas); }
    QAccessibleInterface* child(int) const override { return nullptr; }
    QAccessibleInterface* childAt(int, int) const override { return nullptr; }
    int childCount() const override { return 0; }
    int indexOfChild(const QAccessibleInterface*) const override { return -1; }
    QAccessible::Role role() const override { return QAccessible::ListItem; }
    void setText(QAccessible::Text, const QString&) override {}

    QString text(QAccessible::Text kind) const override {
        if (kind != QAccessible::Name || !isValid()) return {};
        return AccessibleCanvasTexts::tr("Fragment %1").arg(nameText(m_state.pattern->fragmentId(m_piece)));
    }
    /// The bounding rectangle on the screen.
    QRect rect() const override {
        if (!isValid()) return {};
        const Box2& box = m_state.pattern->box(m_piece);
        const QRectF area =
            QRectF(m_state.view.pixels({box.min.x, box.max.y}), m_state.view.pixels({box.max.x, box.min.y}));
        const QRectF near(-kFarAway, -kFarAway, 2.0 * kFarAway, 2.0 * kFarAway);
        return area.intersected(near).toAlignedRect().translated(m_canvas.mapToGlobal(QPoint(0, 0)));
    }
    QAccessible::State state() const override {
        QAccessible::State state;
        if (!isValid()) {
            state.invalid = true;
            return state;
        }
        state.selectable = true;
        state.multiSelectable = true;
        state.selected = isPieceSelected(m_state, m_piece);
        const QRect canvas(m_canvas.mapToGlobal(QPoint(0, 0)), m_canvas.size());
        state.offscreen = !canvas.intersects(rect());
        state.invisible = !m_canvas.isVisible();
        return state;
    }

    void* interface_cast(QAccessible::InterfaceType type) override {
        return type == QAccessible::ActionInterface ? static_cast<QAccessibleActionInterface*>(this) : nullptr;
    }
    QStringList actionNames() const override { return {pressAction(), toggleAction()}; }
    QString localizedActionName(const QString& action) const override {
        if (action == pressAction()) return AccessibleCanvasTexts::tr("Select");
        if (action == toggleAction()) return AccessibleCanvasTexts::tr("Add to Selection or Remove");
        return QAccessibleActionInterface::localizedActionName(action);
    }
    void doAction(const QString& action) override {
        if (!isValid()) return;
        if (action == pressAction()) selectPieces(m_state, {m_piece});
        if (action == toggleAction()) togglePiece(m_state, m_piece);
    }
    QStringList keyBindingsForAction(const QString&) const override { return {}; }

private:
    QWidget& m_canvas;
    const CanvasState& m_state;
    std::weak_ptr<const DrawablePattern> m_pattern;
    std::uint32_t m_piece;
};

}  // namespace

AccessibleCanvas::AccessibleCanvas(QWidget& canvas, const CanvasState& state)
    : QAccessibleWidget(&canvas, QAccessible::List), m_state(state) {}

AccessibleCanvas::~AccessibleCanvas() {
    for (const QAccessible::Id id : std::as_const(m_fragments)) QAccessible::deleteAccessibleInterface(id);
}

QAccessible::State AccessibleCanvas::state() const {
    QAccessible::State state = QAccessibleWidget::state();
    state.multiSelectable = true;
    return state;
}

int AccessibleCanvas::childCount() const { return fragmentCount() + QAccessibleWidget::childCount(); }

QAccessibleInterface* AccessibleCanvas::child(int index) const {
    if (index < 0) return nullptr;
    if (index < fragmentCount()) return fragment(static_cast<std::uint32_t>(index));
    return QAccessibleWidget::child(index - fragmentCount());
}

int AccessibleCanvas::indexOfChild(const QAccessibleInterface* child) const {
    if (const auto* fragment = dynamic_cast<const AccessibleFragment*>(child)) {
        return fragment->isValid() ? static_cast<int>(fragment->piece()) : -1;
    }
    const int index = QAccessibleWidget::indexOfChild(child);
    return index < 0 ? -1 : fragmentCount() + index;
}

QAccessibleInterface* AccessibleCanvas::childAt(int x, int y) const {
    const QPoint at = widget()->mapFromGlobal(QPoint(x, y));
    if (!widget()->rect().contains(at)) return nullptr;
    for (QWidget* child = widget()->childAt(at); child; child = child->parentWidget()) {
        if (child->parentWidget() == widget()) return QAccessible::queryAccessibleInterface(child);
    }
    const std::uint32_t piece = m_state.pattern ? m_state.pattern->pieceAt(m_state.view.metres(at)) : kNone;
    return piece == kNone ? nullptr : fragment(piece);
}

int AccessibleCanvas::fragmentCount() const {
    return m_state.pattern ? static_cast<int>(m_state.pattern->partition().pieceCount()) : 0;
}

void AccessibleCanvas::forgetOldFragments() const {
    if (m_pattern.lock() == m_state.pattern) return;
    for (const QAccessible::Id id : std::as_const(m_fragments)) QAccessible::deleteAccessibleInterface(id);
    m_fragments.clear();
    m_pattern = m_state.pattern;
}

QAccessibleInterface* AccessibleCanvas::fragment(std::uint32_t piece) const {
    forgetOldFragments();
    const auto known = m_fragments.constFind(piece);
    if (known != m_fragments.constEnd()) return QAccessible::accessibleInterface(*known);
    auto* created = new AccessibleFragment(*widget(), m_state, piece);
    m_fragments.insert(piece, QAccessible::registerAccessibleInterface(created));
    return created;
}

}  // namespace rubble
