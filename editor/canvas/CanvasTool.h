#pragma once

#include "editor/canvas/CanvasColours.h"
#include "editor/canvas/CanvasView.h"
#include "editor/canvas/ShownPattern.h"
#include "editor/document/Bakes.h"
#include "editor/document/Document.h"
#include "editor/document/Selection.h"

#include <QKeyEvent>
#include <QMenu>
#include <QPainter>

#include <memory>
#include <optional>

namespace rubble {

/// What a canvas and its tools work on.
struct CanvasState {
    Document& document;
    Selection& selection;
    const Bakes& bakes;
    CanvasView view;
    std::shared_ptr<const ShownPattern> pattern;  // the last one of what is shown; null where there is none
    std::shared_ptr<const Asset> fragment;        // what is shown inside one, see asWhole(); null where it is not known
    bool isSnapping = false;

    /// The asset at hand; null where there is none.
    const Asset* asset() const { return findAsset(document.project(), selection.asset()); }
    bool isInside() const { return !selection.inside().empty(); }
    /// Whose prism and pattern are shown: the asset at hand, or a fragment of it as if that were all. Null where there is none.
    const Asset* shown() const { return isInside() ? fragment.get() : asset(); }
    /// The pattern that is shown, in a copy of the asset at hand that is to be changed.
    Pattern& patternIn(Asset& copy) const;
    /// The fragment at a point that one can go into: it is broken again.
    std::optional<FragmentPath> brokenAt(Vec2 point) const;
};

/// Where the pointer is and what is held with it.
struct CanvasPointer {
    QPointF pixels;
    Vec2 metres;
    Qt::KeyboardModifiers modifiers;
};

/// How far an arrow key moves things, m: a pixel, ten with Shift, a step of the grid where snapping is on. None for others.
std::optional<Vec2> nudgeOf(const QKeyEvent& event, const CanvasState& state);

/// What the left mouse button and the keys do on a canvas. A tool pushes edits into the document and keeps what is going on
/// between press and release.
class CanvasTool : public QObject {
    Q_OBJECT
public:
    explicit CanvasTool(CanvasState& state) : m_state(state) {}

    virtual void press(const CanvasPointer& pointer) = 0;
    /// Also while no button is held.
    virtual void move(const CanvasPointer& pointer) = 0;
    virtual void release(const CanvasPointer& pointer) = 0;
    virtual void doubleClick(const CanvasPointer& pointer) { press(pointer); }
    /// True where the key means something to the tool.
    virtual bool key(const QKeyEvent& event) = 0;
    /// True for a key without modifiers that is the tool's own, though it is elsewhere the shortcut of an action.
    virtual bool ownsKey(int /*key*/) const { return false; }
    /// Puts back what is being dragged or drawn; false where nothing is.
    virtual bool cancel() = 0;
    /// Ends what is being dragged, leaving things as they are now: a step was undone or done again meanwhile.
    virtual void letGo() {}

    virtual void paint(QPainter& painter, const CanvasColours& colours) const = 0;
    virtual Qt::CursorShape cursor() const { return Qt::ArrowCursor; }
    /// One line for the status bar: what can be done now.
    virtual QString hint() const = 0;
    /// Adds what can be done where the pointer is.
    virtual void fillMenu(QMenu& menu, const CanvasPointer& pointer) = 0;

signals:
    /// What the tool paints, its cursor or its hint is another now.
    void changed();
    /// Something to tell the user.
    void said(const QString& sentence);

protected:
    /// The stroke of an arrow key's edit: held down, it is one step to undo.
    quint64 nudgeStroke(bool isRepeated);

    CanvasState& m_state;

private:
    quint64 m_nudgeStroke = 0;
};

}  // namespace rubble
