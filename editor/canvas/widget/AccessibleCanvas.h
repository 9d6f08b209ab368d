#pragma once

#include "editor/canvas/tools/CanvasTool.h"

#include <QAccessibleWidget>
#include <QHash>

namespace rubble {

/// What assistive technologies read of a canvas: a list of the fragments of the shown pattern, in the order of its
/// pieces, followed by the child widgets. The interface of a fragment is created when it is asked for.
class AccessibleCanvas : public QAccessibleWidget {
public:
    /// `state` is that of the canvas and lives as long as the canvas.
    AccessibleCanvas(QWidget& canvas, const CanvasState& state);
    ~AccessibleCanvas() override;

    QAccessible::State state() const override;
    int childCount() const override;
    QAccessibleInterface* child(int index) const override;
    int indexOfChild(const QAccessibleInterface* child) const override;
    /// The widget or the fragment at a point of the screen; null if there is none.
    QAccessibleInterface* childAt(int x, int y) const override;

private:
    int fragmentCount() const;
    void forgetOldFragments() const;
    QAccessibleInterface* fragment(std::uint32_t piece) const;

    const CanvasState& m_state;
    // The interfaces that were asked for, by piece, and the pattern that they are of.
    mutable QHash<std::uint32_t, QAccessible::Id> m_fragments;
    mutable std::weak_ptr<const DrawablePattern> m_pattern;
};

}  // namespace rubble
