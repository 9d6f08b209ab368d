#pragma once

#include "core/base/Parallel.h"
#include "editor/canvas/CanvasLayers.h"
#include "editor/document/Bakes.h"

#include <QColor>

#include <memory>
#include <vector>

namespace rubble {

/// How a seed came to stand where it stands.
enum class SeedOrigin { Scattered, Moved, Placed };

/// A baked pattern with what is needed to draw it and to point at it. Made in linear time whenever the pattern changes;
/// pieces and seeds are named by index.
class ShownPattern {
public:
    explicit ShownPattern(std::shared_ptr<const BakedPattern> baked);

    const BakedPattern& baked() const { return *m_baked; }
    const Seeds& seeds() const { return m_baked->seeds; }
    const Partition& partition() const { return m_baked->partition; }

    /// A corner of a piece in the asset's coordinates, m.
    Vec2 corner(std::size_t corner) const {
        return partition().origin + partition().points[partition().corners[corner]];
    }
    const Box2& box(std::uint32_t piece) const { return m_boxes[piece]; }
    double area(std::uint32_t piece) const { return m_areas[piece]; }
    double volume(std::uint32_t piece) const { return m_areas[piece] * baked().asset->prism.depth; }
    Vec2 middle(std::uint32_t piece) const { return m_middles[piece]; }  // its centre of area, m
    /// From where on an edge that pieces share can be seen, m.
    double leastEdge() const;
    double aspect(std::uint32_t piece) const;
    /// The pieces it touches along an edge that can be seen, ascending.
    std::vector<std::uint32_t> neighbours(std::uint32_t piece) const;
    /// As the fragment is called that the piece becomes: "3/5.17".
    std::string fragmentId(std::uint32_t piece) const;

    /// By what the piece is chosen: its seed, or its cell of a cut layer.
    SeedId cellOf(std::uint32_t piece) const;

    /// The seed's pieces [begin, end); none where it has no cell.
    IndexRange piecesOf(std::uint32_t seed) const;
    /// Around a seed and its pieces.
    Box2 boxOf(std::uint32_t seed) const;
    /// kNone where there is none.
    std::uint32_t pieceAt(Vec2 point) const;
    /// The nearest seed within `reach` metres; kNone where there is none.
    std::uint32_t seedNear(Vec2 point, double reach) const;
    /// Where a site of the triangulation stands: in a grain, not where the triangulation has it.
    Vec2 site(std::uint32_t number) const { return seeds().positions[m_baked->triangulation.seedOf[number]]; }
    /// The triangle of the triangulation (no ghost) that holds a point; kNone where there is none.
    std::uint32_t triangleAt(Vec2 point) const;

    /// The seed's index, kNone where the pattern has none of this name.
    std::uint32_t find(SeedId seed) const;
    SeedOrigin origin(std::uint32_t seed) const;
    /// The number of the seed's layer within the pattern.
    std::size_t layerNumber(std::uint32_t seed) const;
    /// What the bake reports of a seed.
    bool isDuplicate(std::uint32_t seed) const { return m_marks[seed] == Mark::Duplicate; }
    bool hasNoCell(std::uint32_t seed) const { return m_marks[seed] == Mark::NoCell; }

    /// How many seeds there are of each sort, for a legend.
    struct Counts {
        std::size_t scattered = 0, moved = 0, placed = 0;
        std::size_t duplicates = 0, withoutCell = 0;
    };
    const Counts& counts() const { return m_counts; }

    /// The least and the greatest value that a colouring shows, for its scale; equal where it has none, as by Level, which
    /// follows from the bake. Masses are told as volumes.
    struct Range {
        double least = 0.0;
        double most = 0.0;
        bool operator==(const Range&) const = default;
    };
    Range range(CellColouring colouring) const;
    /// `colouring` is not None; `range` is its own.
    QColor colour(std::uint32_t piece, CellColouring colouring, Range range) const;

private:
    enum class Mark : std::uint8_t { None, Duplicate, NoCell };
    /// Seeds [begin, end) are those of one layer, ascending.
    struct Run {
        std::uint32_t layer = 0;
        std::uint32_t begin = 0;
        std::uint32_t end = 0;
    };
    void measure(std::uint32_t piece);
    void takeReports();
    void countSorts();
    /// Of Mass without the density, of Threshold without that of the whole: those are not the pattern's.
    double value(std::uint32_t piece, CellColouring colouring) const;

    std::shared_ptr<const BakedPattern> m_baked;
    std::vector<Box2> m_boxes;    // this and the following: one a piece
    std::vector<double> m_areas;  // m^2
    std::vector<Vec2> m_middles;  // m
    std::vector<Mark> m_marks;    // one a seed
    std::vector<Run> m_runs;      // one a layer that has seeds
    Counts m_counts;
};

void include(Box2& box, const Box2& other);

/// A box around all that two patterns draw differently; empty where they look the same.
Box2 differenceBox(const ShownPattern& before, const ShownPattern& after);

}  // namespace rubble
