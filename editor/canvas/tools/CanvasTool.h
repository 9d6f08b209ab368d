#pragma once

#include "editor/canvas/painting/CanvasColours.h"
#include "editor/canvas/painting/CanvasView.h"
#include "editor/canvas/painting/DrawablePattern.h"
#include "editor/commands/BondPainter.h"
#include "editor/document/Bakes.h"
#include "editor/document/Document.h"
#include "editor/document/Selection.h"
#include "editor/widgets/numbers/Units.h"

#include <QKeyEvent>
#include <QMenu>
#include <QPainter>

#include <memory>
#include <optional>

namespace rubble {

/// What a canvas shows, for its tools. The canvas alone writes it; a tool, to which it is constant, changes the models
/// that it names: it pushes edits, sets the selection and paints with the brush.
struct CanvasState {
    Document& document;
    Selection& selection;
    const Bakes& bakes;
    BondPainter& bondPainter;
    CanvasView view;
    std::shared_ptr<const DrawablePattern> pattern;  // the last baked one; may be null
    std::shared_ptr<const Asset> fragment;  // the entered one, or the section of a mesh, as an asset; null if not known
    Units units;                            // of displayed quantities
    bool isSnapping = false;
    Vec2 fragmentOffset{0.0};        // of the entered fragment's frame in the asset's plane, m; 0: none is entered
    mutable bool isPushing = false;  // push() is applying an edit

    /// The active asset; null if there is none.
    const Asset* asset() const { return findAsset(document.project(), selection.asset()); }
    bool isInFragment() const { return !selection.enteredFragment().empty(); }
    /// The asset whose prism and pattern are shown: the active one, or the entered fragment or the section of a mesh as
    /// an asset. Null if there is none.
    const Asset* displayedAsset() const { return isInFragment() || isMesh() ? fragment.get() : asset(); }
    /// Updates the entered fragment from the document and the bakes.
    void refreshFragment();
    /// Whether the active asset is a mesh, of which a section is shown.
    bool isMesh() const { return asset() && !asset()->isPrism(); }
    /// The asset that is displayed in the plane in which its outline, layers and strokes are; null for a mesh that is
    /// seen along another axis than z.
    const Asset* assetInItsPlane() const;
    /// The displayed asset if it is cut in the plane; null for a mesh.
    const Asset* planarAsset() const { return isMesh() ? nullptr : displayedAsset(); }
    /// Moves a seed of the displayed pattern to a position in its plane.
    void moveSeed(Pattern& changed, SeedId seed, Vec2 position) const;
    /// Adds a seed at a position in the plane.
    void placeSeed(PatternLayer& layer, Vec2 position) const;
    /// Pushes an edit of a tool; other edits end a drag.
    bool push(Edit edit) const;
    /// The displayed pattern within `copy`, a copy of the active asset that is being changed.
    Pattern& patternIn(Asset& copy) const;
    /// The fractured fragment at a point, which can be entered; none if there is none.
    std::optional<FragmentPath> fracturedFragmentAt(Vec2 point) const;
    /// Why no pattern is shown, as a sentence; empty if one is, or will be soon.
    QString placeholder() const;
};

/// Adds actions that enter the fractured fragment at a point and exit the entered one to a menu, as far as possible.
void addFragmentNavigation(QMenu& menu, const CanvasState& state, Vec2 point);

/// The pointer's position with the modifier keys.
struct CanvasPointer {
    QPointF pixels;
    Vec2 metres;
    Qt::KeyboardModifiers modifiers;
};

/// The displacement of an arrow key, m: one pixel, ten with Shift, one grid step if snapping is on. None for other
/// keys.
std::optional<Vec2> nudgeStep(const QKeyEvent& event, const CanvasState& state);

/// Handles the left mouse button and the keys on a canvas. A tool pushes edits into the document and holds the state of
/// a drag.
class CanvasTool : public QObject {
    Q_OBJECT
public:
    explicit CanvasTool(const CanvasState& state) : m_state(state) {}

    virtual void press(const CanvasPointer& pointer) = 0;
    /// Also called while no button is held.
    virtual void move(const CanvasPointer& pointer) = 0;
    virtual void release(const CanvasPointer& pointer) = 0;
    virtual void doubleClick(const CanvasPointer& pointer) { press(pointer); }
    /// True if the tool handled the key; by default, Esc cancels.
    virtual bool key(const QKeyEvent& event) { return event.key() == Qt::Key_Escape && cancel(); }
    /// The wheel was turned by some notches with Ctrl; true if the tool handled it.
    virtual bool controlWheel(double /*notches*/) { return false; }
    /// Whether the tool handles this key (without modifiers) in place of an action that has it as shortcut.
    virtual bool overridesShortcut(int /*key*/) const { return false; }
    /// Cancels the current drag or drawing and restores the state before; false if there is none.
    virtual bool cancel() = 0;
    /// The pointer left the canvas.
    virtual void leave() {}
    /// Ends the current drag without a change: its starting state is outdated by an undo, a redo or another edit.
    virtual void endDrag() {}

    virtual void paint(QPainter& painter, const CanvasColours& colours) const = 0;
    virtual Qt::CursorShape cursor() const { return Qt::ArrowCursor; }
    /// The status bar's hint on what the tool can do now.
    virtual QString hint() const = 0;
    /// Whether the canvas shows the hint, too: in the middle of something that takes several clicks.
    virtual bool isPrompting() const { return false; }
    /// Adds the tool's actions at the pointer to a context menu.
    virtual void fillMenu(QMenu& menu, const CanvasPointer& pointer) = 0;

signals:
    /// The tool's painting, cursor or hint changed.
    void changed();
    /// A message for the status bar.
    void statusMessage(const QString& message);

protected:
    /// The merge key of an arrow key's edit; the repeats of a held key are one undo step.
    quint64 nudgeMergeKey(bool isRepeated);

    const CanvasState& m_state;

private:
    quint64 m_nudgeMergeKey = 0;
};

}  // namespace rubble
