#pragma once

#include "core/base/Parallel.h"
#include "editor/canvas/painting/CanvasOverlays.h"
#include "editor/document/Bakes.h"

#include <QColor>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace rubble {

/// The origin of the position of a seed.
enum class SeedOrigin { Scattered, Moved, Placed };

/// A baked pattern prepared for drawing and picking. Built in linear time when the pattern changes; pieces and seeds
/// are identified by index.
class DrawablePattern {
public:
    explicit DrawablePattern(std::shared_ptr<const BakedPattern> baked);

    const BakedPattern& baked() const { return *m_baked; }
    const Seeds& seeds() const { return m_baked->seeds; }
    const Partition& partition() const { return m_baked->partition; }

    /// A corner of a piece in the asset's coordinates, m.
    Vec2 corner(std::size_t corner) const {
        return partition().origin + partition().points[partition().corners[corner]];
    }
    const Box2& box(std::uint32_t piece) const { return m_boxes[piece]; }
    double area(std::uint32_t piece) const { return m_areas[piece]; }
    double volume(std::uint32_t piece) const {
        return baked().section ? baked().volumes[piece] : m_areas[piece] * baked().asset->prism().depth;
    }
    Vec2 centroid(std::uint32_t piece) const { return m_centroids[piece]; }
    /// See minimumSharedEdge(), m.
    double minimumEdge() const;
    double aspect(std::uint32_t piece) const;
    /// The pieces that share an edge of at least minimumEdge(), ascending.
    std::vector<std::uint32_t> neighbours(std::uint32_t piece) const;
    /// The id of the fragment that the piece becomes: "3/5.17".
    std::string fragmentId(std::uint32_t piece) const;
    FragmentPath fragmentPath(std::uint32_t piece) const { return pathOfId(fragmentId(piece)); }

    /// The id by which the piece is selected: that of its seed, or of its cell in a cut layer.
    SeedId cellOf(std::uint32_t piece) const;

    /// The pieces of a seed, [begin, end); empty if it has no cell.
    IndexRange piecesOf(std::uint32_t seed) const;
    /// The bounding box of a seed and its pieces.
    Box2 boxOf(std::uint32_t seed) const;
    /// kNone if there is none.
    std::uint32_t pieceAt(Vec2 point) const;
    /// The nearest seed within `radius` metres; kNone if there is none.
    std::uint32_t nearestSeed(Vec2 point, double radius) const;
    /// The position of a site; with a grain, it differs from that in the triangulation.
    Vec2 site(std::uint32_t number) const { return seeds().positions[m_baked->triangulation.seedOf[number]]; }
    /// The triangle (not a ghost) that contains a point; kNone if there is none.
    std::uint32_t triangleAt(Vec2 point) const;

    /// The index of a seed; kNone if it does not exist.
    std::uint32_t find(SeedId seed) const;
    SeedOrigin origin(std::uint32_t seed) const;
    /// The index of the seed's layer in the pattern.
    std::size_t layerIndex(std::uint32_t seed) const;
    bool isDuplicate(std::uint32_t seed) const { return m_defects[seed] == Defect::Duplicate; }
    bool hasNoCell(std::uint32_t seed) const { return m_defects[seed] == Defect::NoCell; }

    /// The number of seeds of each kind, for the legend.
    struct Counts {
        std::size_t scattered = 0, moved = 0, placed = 0;
        std::size_t duplicates = 0, withoutCell = 0;
        /// The index of the layer of all seeds of a SeedOrigin; none if there are none, or of several layers.
        std::array<std::optional<std::size_t>, 3> layers;
    };
    const Counts& counts() const { return m_counts; }

    /// The smallest and largest value of a colouring, for its scale; equal if it has none. Level, which depends on the
    /// bake, has none here; Mass is given as volume.
    struct Range {
        double least = 0.0;
        double most = 0.0;
        bool operator==(const Range&) const = default;
    };
    Range range(CellColouring colouring) const;
    /// `colouring` must not be None; `range` is its range().
    QColor colour(std::uint32_t piece, CellColouring colouring, Range range) const;

private:
    enum class Defect : std::uint8_t { None, Duplicate, NoCell };
    /// The seeds [begin, end) of one layer.
    struct LayerSeeds {
        std::uint32_t layer = 0;
        std::uint32_t begin = 0;
        std::uint32_t end = 0;
    };
    void measure(std::uint32_t piece);
    void readDiagnostics();
    void countOrigins();
    void count(SeedOrigin origin, std::size_t seeds, std::size_t layer);
    /// The value, without the factors that the pattern does not know: the density (Mass) and the asset's threshold
    /// (Threshold).
    double value(std::uint32_t piece, CellColouring colouring) const;

    std::shared_ptr<const BakedPattern> m_baked;
    std::vector<Box2> m_boxes;         // this and the following: one per piece
    std::vector<double> m_areas;       // m²
    std::vector<Vec2> m_centroids;     // m
    std::vector<Defect> m_defects;     // one a seed
    std::vector<LayerSeeds> m_layers;  // one a layer that has seeds
    Counts m_counts;
};

void include(Box2& box, const Box2& other);

/// The bounding box of everything that two patterns draw differently; empty if there is nothing.
Box2 differenceBox(const DrawablePattern& before, const DrawablePattern& after);

}  // namespace rubble
