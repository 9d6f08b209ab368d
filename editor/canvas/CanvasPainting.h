#pragma once

#include "editor/canvas/CanvasColours.h"
#include "editor/canvas/CanvasView.h"
#include "editor/canvas/MovedCells.h"
#include "editor/document/FragmentChoice.h"
#include "editor/document/StateComparison.h"

#include <QPainter>

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace rubble {

/// What a canvas shows of a pattern; painted where it changes only.
struct CanvasContents {
    std::shared_ptr<const ShownPattern> pattern;  // as it was baked; null where there is none
    std::shared_ptr<const MovedPart> moved;       // what changed since; null where nothing did
    std::vector<std::array<Vec2, 2>> around;      // edges of what lies around a fragment that one is in, m
    CanvasLayers layers;
    ShownPattern::Range range;  // of layers.colouring
    FragmentChoice hidden;
    double density = 0.0;    // kg/m^3
    double threshold = 0.0;  // N s, that is in force
    std::map<std::string, int>
        depths;  // by Level: through how many levels fragments are broken again, of those that are
    std::shared_ptr<const ComparedAsset> compared;  // what changed since an earlier state; null where that is not shown

    /// By what cells are coloured: by nothing where changes are shown, so that these stand out.
    CellColouring colouring() const { return compared ? CellColouring::None : layers.colouring; }

    QColor colour(const ShownPattern& shown, std::uint32_t piece) const;
    /// The state of the asset that is shown; null where there is no pattern.
    const Asset* asset() const;
    /// Where a seed is drawn from, and its number there; kNone where there is none of this name.
    std::pair<const ShownPattern*, std::uint32_t> find(SeedId seed) const;
};

/// Paints background, grid, cells, triangles and seeds into a part of the canvas, in pixels; nothing beyond it.
void paintContents(QPainter& painter, const QRectF& part, const CanvasView& view, const CanvasContents& contents,
                   const CanvasColours& colours);

/// A path around a polygon.
QPainterPath pathOf(const Polygon& polygon, const CanvasView& view);
QPainterPath pathOfPiece(const ShownPattern& pattern, std::uint32_t piece, const CanvasView& view);

/// How far apart seeds stand at a view, about, pixels.
double seedSpacing(const ShownPattern& pattern, const CanvasView& view);
/// How large seeds are drawn, pixels: smaller where they crowd.
double seedRadius(const ShownPattern& pattern, const CanvasView& view);
/// A seed's sign: a disc where it was scattered, a diamond where it was moved by hand, a square where it was placed.
void paintSeedSign(QPainter& painter, QPointF centre, double radius, SeedOrigin origin);

}  // namespace rubble
