#include "core/fracture/kinds/RadialCracks.h"

#include "core/base/math/Power.h"
#include "core/base/math/Trigonometry.h"
#include "core/fracture/cuts/CutSet.h"
#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/layer/LayerKind.h"
#include "core/fracture/sampling/PairIndex.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <numbers>

namespace rubble {
namespace {

constexpr double kCrackLength = 1.1;  // of the distance to the farthest corner, to which cracks run
constexpr double kMaxRings = 200.0;   // cracks of one layer may cross all cells
constexpr double kMaxSpokes = 1000.0;
constexpr double kFewestArcs = 0.25;  // of the sectors have an arc of the outermost ring
constexpr double kShortCracks = 0.7;  // of the arcs have a short crack outwards
constexpr double kBend = 0.15;        // of the angle by which a crack varies, from ring to ring

constexpr std::array kRadialCracksParameters{
    parameter<&RadialCracks::centre>({.name = "centre",
                                      .caption = "Centre",
                                      .hint = "Point of impact; drag it in the canvas",
                                      .quantity = Quantity::Length}),
    parameter<&RadialCracks::radius>({.name = "radius",
                                      .caption = "Radius",
                                      .hint = "Radius of the outermost ring; long cracks run on to the outline",
                                      .quantity = Quantity::Length,
                                      .range = kAboveZero,
                                      .sliderRange = {0.01, 5.0, true}}),
    parameter<&RadialCracks::rings>({.name = "rings",
                                     .caption = "Rings",
                                     .hint = "Number of rings around the centre; the first is the hole",
                                     .range = {1.0, kMaxRings},
                                     .sliderRange = {1.0, 15.0}}),
    parameter<&RadialCracks::spokes>({.name = "spokes",
                                      .caption = "Long cracks",
                                      .hint = "Number of cracks from the hole to the outline",
                                      .range = {3.0, kMaxSpokes},
                                      .sliderRange = {3.0, 40.0}}),
    parameter<&RadialCracks::exponent>(kRingSpacingParameter),
    parameter<&RadialCracks::rotation>({.name = "rotation",
                                        .caption = "Rotation",
                                        .hint = "Rotation of all cracks about the centre",
                                        .quantity = Quantity::Angle,
                                        .range = {-kFullTurn, kFullTurn},
                                        .sliderRange = {-std::numbers::pi, std::numbers::pi}}),
    parameter<&RadialCracks::variation>(
        {.name = "variation",
         .caption = "Variation",
         .hint = "0: straight cracks at equal angles; 1: up to halfway to the neighbouring ring and crack",
         .range = {0.0, 1.0},
         .sliderRange = {0.0, 1.0}}),
};

/// Draws the cracks from the hole outwards, ring by ring. Point `ring` of a long crack lies on that ring, the last one
/// outside the outline; ring 0 is the hole.
class CrackDrawing {
public:
    CrackDrawing(const RadialCracks& cracks, const LayerContext& context, CutSet& cuts)
        : m_cracks(cracks), m_context(context), m_cuts(cuts), m_open(cracks.spokes, kNone) {
        double farthest = cracks.radius;
        for (const Vec2 corner : context.outline.outer)
            farthest = std::max(farthest, glm::distance(corner, cracks.centre));
        m_farthest = kCrackLength * farthest;
        for (std::uint32_t spoke = 0; spoke < cracks.spokes; ++spoke)
            m_angles.push_back(spoke + cracks.variation * (randomOf(0, spoke).unit() - 0.5) / 2.0);
    }

    /// Draws all cracks; false if cancelled.
    bool draw() {
        for (std::uint32_t ring = 0; ring <= m_cracks.rings; ++ring) {
            if (m_context.task.isCancelled()) return false;
            placePoints(ring);
            for (std::uint32_t spoke = 0; spoke < m_cracks.spokes; ++spoke) drawSector(ring, spoke);
            m_before.swap(m_points);
        }
        return true;
    }

private:
    /// The random stream of a crack at a ring.
    Random randomOf(std::uint32_t ring, std::uint32_t spoke) const {
        return m_context.randomOf(pairIndex(ring, spoke));
    }

    double radiusAt(double ring) const {
        return m_cracks.radius * power((ring + 1.0) / m_cracks.rings, m_cracks.exponent);
    }

    /// Adds the points of the long cracks on a ring, and lengthens the cracks to them.
    void placePoints(std::uint32_t ring) {
        const bool isLast = ring == m_cracks.rings;
        m_points.clear();
        for (std::uint32_t spoke = 0; spoke < m_cracks.spokes; ++spoke) {
            Random random = randomOf(ring + 1, spoke);
            const double bend = kBend * m_cracks.variation * (random.unit() - 0.5);
            const double shift = m_cracks.variation * (random.unit() - 0.5);
            const double angle = m_cracks.rotation + kFullTurn * (m_angles[spoke] + bend) / m_cracks.spokes;
            const double radius = isLast ? m_farthest : radiusAt(ring + (ring == 0 ? shift / 2.0 : shift));
            m_points.push_back(
                m_cuts.addPoint(m_cracks.centre + std::min(radius, m_farthest) * Vec2(cosine(angle), sine(angle))));
            if (ring > 0) addEdge(m_before[spoke], m_points[spoke]);
        }
    }

    /// Draws what lies between a long crack and the next one: the arc, if the ring has one here, the end of the short
    /// crack that comes from within, and the start of the next one.
    void drawSector(std::uint32_t ring, std::uint32_t spoke) {
        const std::uint32_t left = m_points[spoke], right = m_points[(spoke + 1) % m_cracks.spokes];
        Random random = randomOf(ring + 1, spoke + m_cracks.spokes);
        const bool hasArc = ring < m_cracks.rings && random.unit() < fractionOfArcs(ring);
        const double middle = 0.5 + 0.3 * m_cracks.variation * (random.unit() - 0.5);
        std::uint32_t& open = m_open[spoke];
        std::uint32_t last = left;
        if (open != kNone) {
            const std::uint32_t end = between(left, right, middle);
            addEdge(open, end);
            if (hasArc) addEdge(left, end);
            last = end;
            open = hasArc ? kNone : end;
        }
        if (!hasArc) return;
        if (random.unit() < kShortCracks) {
            const std::uint32_t start = between(last, right, last == left ? middle : 0.5);
            addEdge(last, start);
            last = open = start;
        }
        addEdge(last, right);
    }

    double fractionOfArcs(std::uint32_t ring) const {
        return 1.0 - (1.0 - kFewestArcs) * ring / std::max(1.0, m_cracks.rings - 1.0);
    }

    std::uint32_t between(std::uint32_t from, std::uint32_t to, double fraction) {
        return m_cuts.addPoint(glm::mix(m_cuts.points[from], m_cuts.points[to], fraction));
    }

    void addEdge(std::uint32_t from, std::uint32_t to) { m_cuts.edges.push_back({from, to, m_edges++}); }

    const RadialCracks& m_cracks;
    const LayerContext& m_context;
    CutSet& m_cuts;
    double m_farthest = 0.0;                        // m
    std::vector<double> m_angles;                   // of the long cracks, in spokes
    std::vector<std::uint32_t> m_points, m_before;  // of the long cracks on this ring and the one before
    std::vector<std::uint32_t> m_open;  // the last point of the short crack in each sector; kNone: there is none
    std::uint32_t m_edges = 0;
};

}  // namespace

constinit const LayerKind RadialCracks::kKind{.name = "radialCracks",
                                              .caption = "Radial cracks",
                                              .hint = "Cracks that run outwards from a hole, as in glass",
                                              .icon = "layer-radial-cracks",
                                              .summary = "{spokes} long, {rings|1 ring|%1 rings}",
                                              .role = LayerRole::Cuts,
                                              .parameters = kRadialCracksParameters,
                                              .isRandom = true};

RadialCracks RadialCracks::defaultsFor(const Box3& bounds) {
    return RadialCracks{.centre = Vec2(bounds.min + bounds.max) / 2.0, .radius = bounds.diagonal() / 4.0};
}

Status RadialCracks::cut(const LayerContext& context, CutSet& cuts) const {
    if (!CrackDrawing(*this, context, cuts).draw()) return TaskContext::cancelled();
    cuts.layers.push_back({context.layerId, static_cast<std::uint32_t>(cuts.edges.size()), false, nullptr});
    return success();
}

}  // namespace rubble
