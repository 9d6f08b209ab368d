#pragma once

#include "core/base/Diagnostic.h"
#include "core/fracture/fragments/ExtrudedPieces.h"
#include "core/fracture/fragments/SolidFragments.h"
#include "core/geometry/hull/MassProperties.h"
#include "core/geometry/hull/Polytope.h"

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace rubble {

/// A neighbouring fragment and the contact area.
struct FragmentContact {
    std::uint32_t fragment = 0;  // index in the same list
    double area = 0.0;           // m²
};

struct Fragments;
class ExtrudedFragment;

/// One solid fragment of a prism or of a closed mesh. Its own frame has the axes of what it was cut from, and its
/// centre of mass as origin.
///
/// A view, valid while the Fragments object exists and is not moved.
class Fragment {
public:
    Fragment(const Fragments& all, std::uint32_t index) : m_all(&all), m_index(index) {}

    std::uint32_t seed() const;                     // input index; kNone: no seeds
    std::uint32_t partOfCell() const;               // its number among the fragments of its cell; kNone: the only one
    Vec3 offset() const;                            // centre of mass, m: see Fragments::origin
    double volume() const;                          // m³, that of mass()
    MassProperties mass() const;                    // at density 1, transferred mass included; centre (0, 0, 0)
    double aspectRatio() const;                     // of its outline, or of the body: see aspectRatio()
    bool isConvex() const;                          // up to rounding: it collides as one hull
    std::vector<FragmentContact> contacts() const;  // ascending fragment
    /// The convex hulls that it collides as, in its frame. Those of an extruded fragment fill it: one if its outline is
    /// convex, otherwise one per convex part; corners on straight sides, or reflex by no more than rounding, are
    /// omitted. Those of a fragment of a mesh follow it as HullLimits say.
    std::vector<Polytope> hulls() const;

    /// What only an extruded fragment has; nothing for one that was cut from a mesh.
    std::optional<ExtrudedFragment> extruded() const;

    /// The fragments that this is a view of, and its index there.
    const Fragments& all() const { return *m_all; }
    std::uint32_t index() const { return m_index; }

private:
    const Fragments* m_all;
    std::uint32_t m_index;
};

/// A fragment that is a piece of an outline, extruded. A view, as Fragment is: outline and neighbours are computed from
/// the partition on each call, in O(n log n) in the piece's corners.
class ExtrudedFragment {
public:
    ExtrudedFragment(const ExtrudedPieces& all, std::uint32_t index) : m_all(&all), m_index(index) {}

    double depth() const { return m_all->depth; }       // m
    Polygon outline() const;                            // the exact piece, m, in the fragment's frame
    std::vector<std::uint32_t> edgeNeighbours() const;  // of each edge, ring after ring: a fragment; kNone: outside
    Polygon cell() const;                               // the piece before a gap was taken off, in the same frame
    std::vector<std::uint32_t> cellNeighbours() const;  // as edgeNeighbours(), of the cell
    std::uint32_t piece() const { return m_all->pieceOfFragment[m_index]; }
    const PieceRecord& record() const { return m_all->records[piece()]; }

    std::vector<FragmentContact> contacts() const;
    std::vector<Polytope> hulls() const;
    MassProperties mass() const;

private:
    std::vector<std::uint32_t> neighboursIn(const Partition& partition) const;

    const ExtrudedPieces* m_all;
    std::uint32_t m_index;
};

/// The fragments of a prism or of a closed mesh: see extrudedFragments() and solidFragments(). All arrays are flat; use
/// operator[] to read them.
struct Fragments {
    std::variant<ExtrudedPieces, SolidFragments> parts;
    double gap = 0.0;            // m between fragments; 0: none
    Vec3 origin{0.0, 0.0, 0.0};  // of the frame of what was cut in that of `Fragment::offset()`, m
    std::vector<Diagnostic> diagnostics;

    /// Null if they were cut from a mesh.
    const ExtrudedPieces* extruded() const { return std::get_if<ExtrudedPieces>(&parts); }
    ExtrudedPieces* extruded() { return std::get_if<ExtrudedPieces>(&parts); }
    /// Null if they were cut from a prism.
    const SolidFragments* solid() const { return std::get_if<SolidFragments>(&parts); }

    std::uint32_t count() const;
    Fragment operator[](std::uint32_t index) const { return {*this, index}; }
};

}  // namespace rubble
