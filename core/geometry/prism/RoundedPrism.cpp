#include "core/geometry/prism/RoundedPrism.h"

#include "core/geometry/prism/AxisView.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rubble {
namespace {

// Cosine, 45 degrees, of the angle to the axis above which a normal is that of a cap.
constexpr double kCapNormal = 0.7071;
// Faces lower than this many times the rounding have no reliable normal.
constexpr double kSliver = 4.0;
// Each step squares the error of the axis; the first one is below some percent.
constexpr int kSteps = 3;

/// A sum of squares (gradient · tilt + value)², where the tilt (x, y) changes the axis z to (x, y, 1).
class TiltSquares {
public:
    void add(Vec2 gradient, double value) {
        m_xx += gradient.x * gradient.x;
        m_xy += gradient.x * gradient.y;
        m_yy += gradient.y * gradient.y;
        m_right -= value * gradient;
    }
    /// The tilt with the smallest sum; none if it is not determined.
    std::optional<Vec2> smallest() const {
        constexpr double kSingular = 1e-9;
        const double determinant = m_xx * m_yy - m_xy * m_xy;
        if (!(determinant > kSingular * (m_xx + m_yy) * (m_xx + m_yy))) return std::nullopt;
        return Vec2(m_yy * m_right.x - m_xy * m_right.y, m_xx * m_right.y - m_xy * m_right.x) / determinant;
    }

private:
    double m_xx = 0.0, m_xy = 0.0, m_yy = 0.0;
    Vec2 m_right{0.0, 0.0};
};

/// Adds the heights of a cap's points over their mean.
void addCap(const std::vector<Vec3>& points, const std::vector<char>& isInCap, TiltSquares& squares) {
    Vec3 mean{0.0, 0.0, 0.0};
    double count = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!isInCap[i]) continue;
        mean += points[i];
        count += 1.0;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!isInCap[i]) continue;
        const Vec3 offset = points[i] - mean / count;
        squares.add({offset.x, offset.y}, offset.z);
    }
}

/// The tilt of the axis that makes caps flat and sides straight.
std::optional<Vec2> bestTilt(const TriangleMesh& mesh, const ViewFrame& frame, double rounding) {
    std::vector<Vec3> points;
    for (const Vec3 point : mesh.points) points.push_back(frame.fromWorld(point));
    TiltSquares squares;
    std::vector<char> isTop(points.size(), 0), isBottom(points.size(), 0);
    for (const auto& triangle : mesh.triangles) {
        const Vec3 a = points[triangle[0]], b = points[triangle[1]], c = points[triangle[2]];
        const Vec3 normal = glm::cross(b - a, c - a);
        const double size = glm::length(normal);
        const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
        if (size <= kSliver * rounding * longest) continue;
        if (std::abs(normal.z) >= kCapNormal * size) {
            std::vector<char>& isInCap = normal.z > 0.0 ? isTop : isBottom;
            for (const std::uint32_t corner : triangle) isInCap[corner] = 1;
        } else {
            const double width = std::max(
                {std::hypot(b.x - a.x, b.y - a.y), std::hypot(c.x - b.x, c.y - b.y), std::hypot(a.x - c.x, a.y - c.y)});
            squares.add(Vec2(normal.x, normal.y) / width, normal.z / width);
        }
    }
    addCap(points, isTop, squares);
    addCap(points, isBottom, squares);
    return squares.smallest();
}

}  // namespace

Vec3 axisOfLeastSquares(const TriangleMesh& mesh, Vec3 axis, double rounding) {
    for (int step = 0; step < kSteps; ++step) {
        const ViewFrame frame = frameAlong(axis, boundsOf(mesh).centre());
        const std::optional<Vec2> tilt = bestTilt(mesh, frame, rounding);
        if (!tilt) break;
        axis = glm::normalize(frame.z + tilt->x * frame.x + tilt->y * frame.y);
    }
    return axis;
}

std::vector<Ring> ringsBetween(std::vector<Ring> top, const std::vector<Ring>& bottom, double radius) {
    std::vector<Vec2> points;
    for (const Ring& ring : bottom) points.insert(points.end(), ring.begin(), ring.end());
    std::ranges::sort(points, lexicographicLess);
    for (Ring& ring : top) {
        for (Vec2& corner : ring) {
            const Vec2 at = corner;
            double nearest = radius;
            const auto first = std::ranges::lower_bound(points, at.x - radius, {}, &Vec2::x);
            for (auto point = first; point != points.end() && point->x <= at.x + radius; ++point) {
                if (glm::distance(*point, at) > nearest) continue;
                nearest = glm::distance(*point, at);
                corner = (at + *point) / 2.0;
            }
        }
    }
    return top;
}

}  // namespace rubble
