#include "core/fracture/sampling/SolidScatter.h"

#include "core/fracture/sampling/TriangleSampling.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <numeric>
#include <queue>
#include <span>

namespace rubble {
namespace {

constexpr std::size_t kMaxParts = 1 << 14;
constexpr std::size_t kMaxClipped = 64;    // triangles in a box that are clipped by it; more are only counted
constexpr double kEnoughWeight = 1.5;      // of the volume: then two of three points hit
constexpr double kSmallPart = 1.0 / 2048;  // of all weight: parts as light as that are not divided
constexpr int kMaxAttempts = 10'000;
constexpr int kMaxAttemptsNear = 1000;

double volumeOf(const Box3& box) {
    const Vec3 size = glm::max(box.max - box.min, Vec3(0.0));
    return size.x * size.y * size.z;
}

Box3 intersection(const Box3& a, const Box3& b) { return {glm::max(a.min, b.min), glm::min(a.max, b.max)}; }

bool contains(const Box3& box, Vec3 point) {
    return glm::all(glm::lessThanEqual(box.min, point)) && glm::all(glm::lessThanEqual(point, box.max));
}

/// Clips a convex polygon by the half-space of points whose coordinate, times `side`, is at most `limit`.
void clip(std::vector<Vec3>& polygon, int axis, double side, double limit) {
    std::vector<Vec3> clipped;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec3 from = polygon[k], to = polygon[(k + 1) % polygon.size()];
        const double before = side * from[axis] - limit, after = side * to[axis] - limit;
        if (before <= 0.0) clipped.push_back(from);
        if ((before < 0.0 && after > 0.0) || (before > 0.0 && after < 0.0))
            clipped.push_back(glm::mix(from, to, before / (before - after)));
    }
    polygon.swap(clipped);
}

Vec3 areaVector(std::span<const Vec3> polygon) {
    Vec3 sum(0.0);
    for (std::size_t k = 2; k < polygon.size(); ++k)
        sum += glm::cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
    return sum;
}

/// Unit vectors: a normal, and two perpendicular to it, the first along an edge.
Mat3 frameOf(Vec3 normal, Vec3 edge) {
    const Vec3 along = glm::normalize(edge);
    return {along, glm::normalize(glm::cross(normal, along)), glm::normalize(normal)};
}

/// The part of a surface within a box.
struct ClippedSurface {
    std::vector<std::uint32_t> triangles;
    std::vector<Vec3> points;
    Vec3 normal{0.0};  // of the largest piece
    Vec3 edge{0.0};    // its longest
};

ClippedSurface clippedSurface(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles, const Box3& box) {
    ClippedSurface surface;
    double largest = 0.0;
    std::vector<Vec3> polygon;
    for (const std::uint32_t triangle : triangles) {
        polygon.clear();
        for (const std::uint32_t point : mesh.triangles[triangle]) polygon.push_back(mesh.points[point]);
        for (int axis = 0; axis < 3 && !polygon.empty(); ++axis) {
            clip(polygon, axis, -1.0, -box.min[axis]);
            clip(polygon, axis, 1.0, box.max[axis]);
        }
        if (polygon.empty()) continue;
        surface.triangles.push_back(triangle);
        surface.points.insert(surface.points.end(), polygon.begin(), polygon.end());
        const Vec3 normal = areaVector(polygon);
        const double size = glm::dot(normal, normal);
        if (!(size > largest)) continue;
        largest = size;
        surface.normal = normal;
        surface.edge = Vec3(0.0);
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const Vec3 edge = polygon[(k + 1) % polygon.size()] - polygon[k];
            if (glm::dot(edge, edge) > glm::dot(surface.edge, surface.edge)) surface.edge = edge;
        }
    }
    return surface;
}

}  // namespace

double SolidScatter::Part::weight() const { return most * volumeOf(turned); }

/// Divides parts, the heaviest first.
class SolidScatterBuilder {
public:
    SolidScatterBuilder(SolidScatter& scatter, const TaskContext& task)
        : m_scatter(scatter), m_surface(scatter.m_surface), m_task(task) {}

    Status build() {
        std::vector<std::uint32_t> all(m_surface.mesh().triangles.size());
        std::iota(all.begin(), all.end(), 0u);
        add(m_surface.bounds(), all);
        while (!m_open.empty() && m_nodes.size() < 2 * kMaxParts && !isEnough()) {
            if (m_task.isCancelled()) return TaskContext::cancelled();
            const auto [weight, negativeIndex] = m_open.top();
            const auto index = static_cast<std::size_t>(-negativeIndex);
            m_open.pop();
            if (!m_scatter.m_density.isConstant() && weight <= kSmallPart * m_total) break;
            divide(index);
        }
        double sum = 0.0;
        for (const Node& node : m_nodes) {
            if (node.isDivided) continue;
            m_scatter.m_parts.push_back(node.part);
            m_scatter.m_weightsUpTo.push_back(sum += node.part.weight());
        }
        return success();
    }

private:
    struct Node {
        SolidScatter::Part part;
        std::vector<std::uint32_t> triangles;
        bool isDivided = false;
    };

    bool isEnough() const { return m_scatter.m_density.isConstant() && m_total <= kEnoughWeight * m_surface.volume(); }

    void divide(std::size_t index) {
        const Box3 box = m_nodes[index].part.box;
        const std::vector<std::uint32_t> triangles = std::move(m_nodes[index].triangles);
        m_nodes[index].isDivided = true;
        subtract(m_nodes[index].part.weight());
        const Vec3 size = box.max - box.min;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        Box3 low = box, high = box;
        low.max[axis] = high.min[axis] = box.min[axis] + size[axis] / 2.0;
        add(low, triangles);
        add(high, triangles);
    }

    /// Subtracts a weight from the total; where hardly any is left, digits are lost, and it is summed anew.
    void subtract(double weight) {
        m_total -= weight;
        if (m_total > 1e-6 * weight) return;
        m_total = 0.0;
        for (const Node& node : m_nodes) m_total += node.isDivided ? 0.0 : node.part.weight();
    }

    /// Adds a box, of which only what can contain solid is kept.
    void add(const Box3& box, std::span<const std::uint32_t> candidates) {
        Node node{{.box = box, .turned = box}, {}};
        for (const std::uint32_t triangle : candidates) {
            if (isNear(triangle, box)) node.triangles.push_back(triangle);
        }
        if (node.triangles.size() <= kMaxClipped && !enclose(node)) return;
        if (m_scatter.m_density.maxIn) node.part.most = m_scatter.m_density.maxIn(node.part.box);
        const double weight = node.part.weight();
        if (!(weight > 0.0)) return;
        m_total += weight;
        const bool isDone = node.part.isSolid && m_scatter.m_density.isConstant();
        if (!isDone) m_open.push({weight, -static_cast<std::int64_t>(m_nodes.size())});
        m_nodes.push_back(std::move(node));
    }

    bool isNear(std::uint32_t triangle, const Box3& box) const {
        Box3 of;
        for (const std::uint32_t point : m_surface.mesh().triangles[triangle])
            of.include(m_surface.mesh().points[point]);
        return glm::all(glm::lessThanEqual(of.min, box.max)) && glm::all(glm::lessThanEqual(box.min, of.max));
    }

    /// Encloses the solid of a box, which lies within the convex hull of its surface and of corners that are solid, in
    /// the smaller one of two boxes. False if there is none.
    bool enclose(Node& node) const {
        const Box3 box = node.part.box;
        ClippedSurface surface = clippedSurface(m_surface.mesh(), node.triangles, box);
        if (surface.points.empty()) {
            node.triangles.clear();
            node.part.isSolid = m_surface.contains(box.centre());
            return node.part.isSolid;
        }
        for (int k = 0; k < 8; ++k) {
            if (m_surface.contains(box.corner(k))) surface.points.push_back(box.corner(k));
        }
        Box3 around;
        for (const Vec3 point : surface.points) around.include(point);
        node.part.box = node.part.turned = intersection(box, around);
        node.triangles = std::move(surface.triangles);
        if (surface.edge == Vec3(0.0)) return true;
        const Mat3 axes = frameOf(surface.normal, surface.edge);
        Box3 turned;
        for (const Vec3 point : surface.points) turned.include(glm::transpose(axes) * point);
        if (volumeOf(turned) < volumeOf(node.part.turned)) {
            node.part.axes = axes;
            node.part.turned = turned;
        }
        return true;
    }

    SolidScatter& m_scatter;
    const SolidSurface& m_surface;
    const TaskContext& m_task;
    std::vector<Node> m_nodes;
    std::priority_queue<std::pair<double, std::int64_t>> m_open;  // {weight, -index}: the first of equal ones
    double m_total = 0.0;
};

Result<SolidScatter> SolidScatter::of(const SolidSurface& surface, const SolidDensity& density,
                                      const TaskContext& task) {
    SolidScatter scatter(surface, density);
    if (const Status built = SolidScatterBuilder(scatter, task).build(); !built) return built.error();
    return scatter;
}

std::optional<Vec3> SolidScatter::pointOf(const Part& part, const Box3& turned, Random& random) const {
    const double x = random.unit(), y = random.unit(), z = random.unit();
    const Vec3 point = part.axes * (turned.min + Vec3(x, y, z) * (turned.max - turned.min));
    if (!m_density.isConstant() && random.unit() * part.most >= m_density.at(point)) return std::nullopt;
    if (!contains(part.box, point)) return std::nullopt;
    return part.isSolid || m_surface.contains(point) ? std::optional(point) : std::nullopt;
}

Vec3 SolidScatter::point(Random& random) const {
    for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
        const Part& part = m_parts[drawByWeight(m_weightsUpTo, random)];
        if (const std::optional<Vec3> point = pointOf(part, part.turned, random)) return *point;
    }
    const Part& part = m_parts[drawByWeight(m_weightsUpTo, random)];
    return part.axes * part.turned.centre();
}

std::optional<Vec3> SolidScatter::pointNear(Vec3 centre, double radius, Random& random) const {
    const Box3 around{centre - radius, centre + radius};
    std::vector<std::size_t> parts;
    std::vector<Box3> boxes;
    std::vector<double> weightsUpTo;
    double sum = 0.0;
    for (std::size_t k = 0; k < m_parts.size(); ++k) {
        const Part& part = m_parts[k];
        const Box3 overlap = intersection(part.box, around);
        if (overlap.min.x > overlap.max.x || overlap.min.y > overlap.max.y || overlap.min.z > overlap.max.z) continue;
        const Vec3 turnedCentre = glm::transpose(part.axes) * centre;
        const Box3 box = intersection(part.turned, {turnedCentre - radius, turnedCentre + radius});
        if (!(volumeOf(box) > 0.0)) continue;
        parts.push_back(k);
        boxes.push_back(box);
        weightsUpTo.push_back(sum += part.most * volumeOf(box));
    }
    if (!(sum > 0.0)) return std::nullopt;
    for (int attempt = 0; attempt < kMaxAttemptsNear; ++attempt) {
        const std::size_t k = drawByWeight(weightsUpTo, random);
        const std::optional<Vec3> point = pointOf(m_parts[parts[k]], boxes[k], random);
        if (point && glm::distance(*point, centre) <= radius) return point;
    }
    return std::nullopt;
}

}  // namespace rubble
