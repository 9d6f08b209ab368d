#pragma once

#include "editor/background/ComparedAsset.h"
#include "editor/canvas/painting/CanvasColours.h"
#include "editor/canvas/painting/CanvasView.h"

#include <QPainter>

namespace rubble {

/// Paints the changed fragments of an asset over its cells: added and reshaped ones are hatched differently, removed
/// ones have a dashed outline, and moved ones a dashed outline at their old position with an arrow to the new one.
/// Every change can be identified by colour or by marker alone. Fragments of deeper levels are only painted if their
/// parent did not change.
void paintChanges(QPainter& painter, const CanvasView& view, const ComparedAsset& compared,
                  const CanvasColours& colours);

/// The legend's marker of a change, about 16 by 10 pixels around a point.
void paintChangeMarker(QPainter& painter, QPointF centre, FragmentChange change, const CanvasColours& colours);
/// The name of a change and its number of fragments: "added: 3".
QString changeText(FragmentChange change, std::size_t count);

}  // namespace rubble
