#include "core/fracture/kinds/SurfaceScatter.h"

#include "core/base/MessageText.h"
#include "core/base/math/Power.h"
#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/layer/LayerKind.h"
#include "core/fracture/sampling/ScatterArea.h"
#include "core/fracture/sampling/TriangleSampling.h"
#include "core/geometry/polygon/ContainmentIndex.h"
#include "core/geometry/search/BoxTree.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kDefaultDepthFraction = 0.08;  // of the domain's diameter: the greatest depth in a new layer
constexpr double kMaxSurfaceFalloff = 8.0;
constexpr int kMaxAttempts = 1000;  // of a seed

constexpr std::array kSurfaceScatterParameters{
    parameter<&SurfaceScatter::count>(kCountParameter),
    parameter<&SurfaceScatter::minDepth>({.name = "minDepth",
                                          .caption = "Minimum depth",
                                          .hint = "Least distance of seeds from the surface",
                                          .quantity = Quantity::Length,
                                          .range = {0.0, std::numeric_limits<double>::max()},
                                          .sliderRange = {0.0, 1.0}}),
    parameter<&SurfaceScatter::maxDepth>({.name = "maxDepth",
                                          .caption = "Maximum depth",
                                          .hint = "Greatest distance of seeds from the surface",
                                          .quantity = Quantity::Length,
                                          .range = kAboveZero,
                                          .sliderRange = {0.005, 2.0, true}}),
    parameter<&SurfaceScatter::falloff>({.name = "falloff",
                                         .caption = "Falloff",
                                         .hint = "How fast the density decreases with depth; 0: constant density",
                                         .range = {0.0, kMaxSurfaceFalloff},
                                         .sliderRange = {0.0, 6.0}}),
};

/// The surface of a closed mesh, by triangles.
class MeshBoundary {
public:
    using Point = Vec3;

    explicit MeshBoundary(const SolidDomain& domain) : m_domain(domain) {
        const TriangleMesh& mesh = domain.mesh();
        double sum = 0.0;
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            m_sizesUpTo.push_back(sum += glm::length(doubleArea(mesh, t)));
    }
    /// A point at a depth below a uniform random point of the surface.
    Vec3 below(double depth, Random& random) const {
        const TriangleMesh& mesh = m_domain.mesh();
        const std::size_t triangle = drawByWeight(m_sizesUpTo, random);
        const auto& [a, b, c] = mesh.triangles[triangle];
        double u = random.unit(), v = random.unit();
        if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
        const Vec3 corner = mesh.points[a], normal = glm::normalize(doubleArea(mesh, triangle));
        return corner + u * (mesh.points[b] - corner) + v * (mesh.points[c] - corner) - depth * normal;
    }
    double depth(Vec3 point) const { return m_domain.depth(point); }

private:
    const SolidDomain& m_domain;
    std::vector<double> m_sizesUpTo;
};

/// The rings of an outline, by edges.
class OutlineBoundary {
public:
    using Point = Vec2;

    explicit OutlineBoundary(const Polygon& outline)
        : m_edges(edgesOf(outline)), m_tree(boxesOf(m_edges)), m_containment(outline) {
        double sum = 0.0;
        for (const auto& [from, to] : m_edges) m_sizesUpTo.push_back(sum += glm::distance(from, to));
    }
    /// A point at a depth beside a uniform random point of the rings.
    Vec2 below(double depth, Random& random) const {
        const auto& [from, to] = m_edges[drawByWeight(m_sizesUpTo, random)];
        return from + random.unit() * (to - from) + depth * glm::normalize(perpendicular(to - from));
    }
    double depth(Vec2 point) const {
        double nearest = HUGE_VAL;
        m_tree.visitNear(Vec3(point, 0.0), [&](std::uint32_t edge) {
            const auto& [from, to] = m_edges[edge];
            const Vec2 along = to - from;
            const double fraction = std::clamp(glm::dot(point - from, along) / glm::dot(along, along), 0.0, 1.0);
            return nearest = std::min(nearest, glm::distance(point, from + fraction * along));
        });
        return m_containment.of(point) == Containment::Outside ? -nearest : nearest;
    }

private:
    using Edges = std::vector<std::array<Vec2, 2>>;
    static Edges edgesOf(const Polygon& outline) {
        Edges edges;
        const auto add = [&edges](const Ring& ring) {
            for (std::size_t k = 0; k < ring.size(); ++k) edges.push_back({ring[k], ring[(k + 1) % ring.size()]});
        };
        add(outline.outer);
        for (const Ring& hole : outline.holes) add(hole);
        return edges;
    }

    Edges m_edges;
    BoxTree m_tree;
    ContainmentIndex m_containment;
    std::vector<double> m_sizesUpTo;
};

/// The depths of a layer, by its density, down to those that the domain has, so that most can be used in thin ones.
class DepthRange {
public:
    /// `area` gives uniform points of the domain of a boundary.
    template <class Boundary, class Area>
    DepthRange(const SurfaceScatter& layer, const Boundary& boundary, const Area& area, const EvaluatedLayer& context)
        : m_layer(layer) {
        constexpr int kSamples = 256;
        constexpr double kMargin = 2.0;  // for what is deeper than all samples
        Random random = context.random();
        double deepest = 0.0;
        for (int k = 0; k < kSamples; ++k) deepest = std::max(deepest, boundary.depth(area.point(random)));
        const double fraction = (kMargin * deepest - layer.minDepth) / (layer.maxDepth - layer.minDepth);
        if (fraction > 0.0 && fraction < 1.0) m_most = 1.0 - power(1.0 - fraction, 1.0 + layer.falloff);
    }
    double drawn(Random& random) const {
        const double t = 1.0 - power(1.0 - m_most * random.unit(), 1.0 / (1.0 + m_layer.falloff));
        return m_layer.minDepth + t * (m_layer.maxDepth - m_layer.minDepth);
    }

private:
    const SurfaceScatter& m_layer;
    double m_most = 1.0;  // of all seeds, those down to the deepest
};

/// Adds seeds below a boundary. A point counts if no part of the boundary is nearer than the one that it is below, so
/// that the density depends on the depth only.
template <class Boundary, class Area>
Status scatterBelow(const SurfaceScatter& layer, std::uint32_t count, const Boundary& boundary, const Area& area,
                    const EvaluatedLayer& context, SeedSet& seeds) {
    constexpr double kTolerance = 1e-6;  // of the depth: rounding of coordinates far from zero
    const std::size_t before = seeds.size();
    const DepthRange depths(layer, boundary, area, context);
    int misses = 0;
    for (std::uint32_t index = 0; index < count && misses < kMaxAttempts; ++index) {
        Random random = context.randomOf(index);
        for (misses = 0; misses < kMaxAttempts; ++misses) {
            if (misses % 64 == 0 && context.task.isCancelled()) return TaskContext::cancelled();
            const double depth = depths.drawn(random);
            const typename Boundary::Point point = boundary.below(depth, random);
            if (!(boundary.depth(point) >= (1.0 - kTolerance) * depth)) continue;
            seeds.add({context.layerId, index}, point, false);
            break;
        }
    }
    const std::size_t found = seeds.size() - before;
    if (found == count) return success();
    seeds.diagnostics.push_back(diagnostic(DiagnosticCode::NoRoom, {.layer = context.layerId},
                                           context.name() + " found room for " + std::to_string(found) + " of " +
                                               std::to_string(count) + " seeds: hardly any point is " +
                                               messageText(layer.minDepth) + " m below the surface.",
                                           static_cast<double>(found)));
    return success();
}

}  // namespace

constinit const LayerKind SurfaceScatter::kKind{.name = "surfaceScatter",
                                                .caption = "Near surface",
                                                .hint = "Seeds below the surface, dense at it",
                                                .icon = "layer-surface",
                                                .summary = "{count|1 seed|%1 seeds}",
                                                .role = LayerRole::Scatters,
                                                .parameters = kSurfaceScatterParameters,
                                                .isRandom = true};

SurfaceScatter SurfaceScatter::defaultsFor(const Box3& bounds) {
    return SurfaceScatter{.maxDepth = kDefaultDepthFraction * bounds.diagonal()};
}

std::optional<std::string> SurfaceScatter::fault() const {
    if (minDepth <= maxDepth) return std::nullopt;
    return quotedName("Minimum depth") + " is " + messageText(minDepth) + " m, but must not be above " +
           quotedName("Maximum depth") + ", which is " + messageText(maxDepth) + " m";
}

Status SurfaceScatter::apply(const LayerContext& context, SeedSet& seeds) const {
    const Result<std::uint32_t> wanted = seedsToAdd(count, context.outline, context, seeds);
    if (!wanted) return wanted.error();
    const Result<ScatterArea> area = ScatterArea::of(context.outline);
    if (!area) return area.error();
    return scatterBelow(*this, *wanted, OutlineBoundary(context.outline), *area, context, seeds);
}

Status SurfaceScatter::applyInSolid(const SolidLayerContext& context, SeedSet& seeds) const {
    const Result<std::uint32_t> wanted = seedsToAdd(count, context.domain.volume(), context, seeds);
    if (!wanted) return wanted.error();
    return scatterBelow(*this, *wanted, MeshBoundary(context.domain), context.domain, context, seeds);
}

double SurfaceScatter::estimatedPiecesIn(const SolidDomain& domain) const {
    return count.in(domain.volume(), SeedSpace::Solid);
}

}  // namespace rubble
