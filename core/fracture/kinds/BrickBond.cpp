#include "core/fracture/kinds/BrickBond.h"

#include "core/fracture/cuts/CutSet.h"
#include "core/fracture/kinds/BrickCourses.h"
#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/layer/LayerKind.h"
#include "core/fracture/sampling/PairIndex.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

// A new layer has bricks of a common format; for outlines smaller or larger than this, in m, they are scaled.
constexpr double kSmallWall = 1.0;
constexpr double kLargeWall = 50.0;

bool hasStretchers(const BrickBond& wall) { return wall.bond != BondKind::Header; }
bool hasHeaders(const BrickBond& wall) { return wall.bond != BondKind::Stretcher && wall.bond != BondKind::Stack; }

constexpr std::array<ParameterOption, 5> kBonds{{{"stretcher", "Stretcher bond"},
                                                 {"stack", "Stack bond"},
                                                 {"english", "English bond"},
                                                 {"header", "Header bond"},
                                                 {"flemish", "Flemish bond"}}};

constexpr std::array kBrickBondParameters{
    parameter<&BrickBond::bond>(
        {.name = "bond", .caption = "Bond", .hint = "How the courses overlap", .options = kBonds}),
    parameter<&BrickBond::length>({.name = "length",
                                   .caption = "Brick length",
                                   .hint = "Long side of a brick, without mortar",
                                   .quantity = Quantity::Length,
                                   .range = kAboveZero,
                                   .sliderRange = {0.02, 2.0, true},
                                   .usedIf = usedIf<BrickBond, hasStretchers>}),
    parameter<&BrickBond::width>({.name = "width",
                                  .caption = "Brick width",
                                  .hint = "Short side of a brick, without mortar",
                                  .quantity = Quantity::Length,
                                  .range = kAboveZero,
                                  .sliderRange = {0.01, 1.0, true},
                                  .usedIf = usedIf<BrickBond, hasHeaders>}),
    parameter<&BrickBond::height>({.name = "height",
                                   .caption = "Brick height",
                                   .hint = "Height of a brick, without mortar",
                                   .quantity = Quantity::Length,
                                   .range = kAboveZero,
                                   .sliderRange = {0.01, 1.0, true}}),
    parameter<&BrickBond::mortar>({.name = "mortar",
                                   .caption = "Mortar",
                                   .hint = "Width of the joints; cuts run along their centre lines",
                                   .quantity = Quantity::Length,
                                   .range = {0.0, std::numeric_limits<double>::max()},
                                   .sliderRange = {0.0, 0.05}}),
    parameter<&BrickBond::origin>({.name = "origin",
                                   .caption = "Origin",
                                   .hint = "Lower left corner of the first course; drag it in the canvas",
                                   .quantity = Quantity::Length}),
    parameter<&BrickBond::depth>({.name = "depth",
                                  .caption = "Brick depth",
                                  .hint = "Size of a brick along z, without mortar",
                                  .quantity = Quantity::Length,
                                  .range = kAboveZero,
                                  .sliderRange = {0.01, 1.0, true},
                                  .isSpatial = true}),
    parameter<&BrickBond::originHeight>({.name = "originHeight",
                                         .caption = "Origin height",
                                         .hint = "Height of the origin, along z",
                                         .quantity = Quantity::Length,
                                         .isSpatial = true,
                                         .isHeight = true}),
};

/// The courses and columns that cover a box, with one more on every side.
struct Wall {
    const BrickCourses courses;
    const Box2 box;
    const int firstCourse;
    const int endCourse;

    Wall(const BrickBond& bond, const Box2& around)
        : courses(bond),
          box(around),
          firstCourse(courses.courseAt(box.min.y) - 1),
          endCourse(courses.courseAt(box.max.y) + 2) {}

    int firstJoint(int course) const { return courses.columnAt(course, box.min.x) - 1; }
    int endJoint(int course) const { return courses.columnAt(course, box.max.x) + 3; }

    bool isTooFar() const {
        const auto isFar = [](int min, int max) {
            return min < -BrickCourses::kMaxIndex || max > BrickCourses::kMaxIndex;
        };
        return isFar(firstCourse + 1, endCourse - 2) || isFar(firstJoint(0) + 1, endJoint(0) - 3) ||
               isFar(firstJoint(1) + 1, endJoint(1) - 3);
    }
    double cells() const {
        const int longest = std::max(endJoint(0) - firstJoint(0), endJoint(1) - firstJoint(1));
        return static_cast<double>(endCourse - firstCourse) * longest;
    }
};

/// Adds the bed joints from the bottom up, and the head joints between each and the one below.
class JointBuilder {
public:
    JointBuilder(const Wall& wall, CutSet& cuts) : m_wall(wall), m_courses(wall.courses), m_cuts(cuts) {}

    /// Adds the bed joint below a course, with a point at every head joint of that course and of the one below.
    void addBedJoint(int course) {
        m_lower.swap(m_upper);
        m_upper.clear();
        const double y = m_courses.bottom(course);
        const bool hasBelow = course > m_wall.firstCourse, hasAbove = course < m_wall.endCourse;
        int below = hasBelow ? m_wall.firstJoint(course - 1) : 0, above = hasAbove ? m_wall.firstJoint(course) : 0;
        const int endBelow = hasBelow ? m_wall.endJoint(course - 1) : 0,
                  endAbove = hasAbove ? m_wall.endJoint(course) : 0;
        std::uint32_t before = kNone;
        std::size_t head = 0;
        while (below < endBelow || above < endAbove) {
            const double xBelow = below < endBelow ? m_courses.left(course - 1, below) : HUGE_VAL;
            const double xAbove = above < endAbove ? m_courses.left(course, above) : HUGE_VAL;
            const double x = std::min(xBelow, xAbove);
            const std::uint32_t point = m_cuts.addPoint({x, y});
            if (before != kNone) m_cuts.edges.push_back({before, point, 0});
            before = point;
            if (xBelow <= x + m_courses.tolerance()) {
                m_cuts.edges.push_back({m_lower[head++], point, 0});
                ++below;
            }
            if (xAbove <= x + m_courses.tolerance()) {
                m_upper.push_back(point);
                ++above;
            }
        }
    }

private:
    const Wall& m_wall;
    const BrickCourses& m_courses;
    CutSet& m_cuts;
    std::vector<std::uint32_t> m_lower;  // starts of the head joints that end in the bed joint
    std::vector<std::uint32_t> m_upper;  // starts of the head joints above it
};

}  // namespace

constinit const LayerKind BrickBond::kKind{.name = "bricks",
                                           .caption = "Bricks",
                                           .hint = "Cuts along the joints of a brick wall",
                                           .icon = "layer-bricks",
                                           .role = LayerRole::Cuts,
                                           .parameters = kBrickBondParameters};

const char* BrickBond::summary() const {
    const bool isHeader = bond == BondKind::Header;
    return isHeader ? "{width} × {height}" : "{length} × {height}";
}

BrickBond BrickBond::defaultsFor(const Box3& bounds) {
    const Vec3 extent = bounds.max - bounds.min;
    const double side = std::max(extent.x, extent.y);
    const double scale = std::max(std::min(1.0, side / kSmallWall), side / kLargeWall);
    BrickBond wall{.origin = Vec2(bounds.min), .originHeight = bounds.min.z};
    for (double* size : {&wall.length, &wall.width, &wall.height, &wall.mortar}) *size *= scale;
    if (extent.z > 0.0) wall.depth *= scale;
    return wall;
}

Status BrickBond::cut(const LayerContext& context, CutSet& cuts) const {
    const Wall wall(*this, boundsOf(context.outline.outer));
    if (wall.isTooFar()) {
        return Error{ErrorCode::Limit,
                     context.name() + " has bricks more than " + std::to_string(BrickCourses::kMaxIndex) +
                         " courses or columns from its origin: increase their size, or move the origin closer."};
    }
    if (!(wall.cells() <= kMaxSeeds)) return tooManySeeds(context);
    JointBuilder builder(wall, cuts);
    for (int course = wall.firstCourse; course <= wall.endCourse; ++course) {
        if (context.task.isCancelled()) return TaskContext::cancelled();
        builder.addBedJoint(course);
    }
    const auto cellAt = [courses = wall.courses](Vec2 point) {
        const int course = courses.courseAt(point.y);
        return BrickCourses::cellIndex(course, courses.columnAt(course, point.x));
    };
    cuts.layers.push_back({context.layerId, static_cast<std::uint32_t>(cuts.edges.size()), true, cellAt});
    return success();
}

double BrickBond::estimatedPieces(double area) const { return area / (length + mortar) / (height + mortar); }

Status BrickBond::applyInSolid(const SolidLayerContext& context, SeedSet& seeds) const {
    constexpr int kMaxNumber = kMaxTripleNumber / 2;  // of courses, columns and rows, in each direction
    const Box3& box = context.domain.bounds();
    const BrickCourses courses(*this);
    const double pitch = depth + mortar;
    const double firstRow = std::floor((box.min.z - originHeight) / pitch),
                 lastRow = std::floor((box.max.z - originHeight) / pitch);
    const int bottom = courses.courseAt(box.min.y), top = courses.courseAt(box.max.y);
    double farthest = std::max({std::abs(firstRow), std::abs(lastRow), std::abs(bottom * 1.0), std::abs(top * 1.0)});
    for (const int course : {0, 1}) {
        for (const double x : {box.min.x, box.max.x})
            farthest = std::max(farthest, std::abs(courses.columnAt(course, x) * 1.0));
    }
    if (!(farthest < kMaxNumber)) {
        return Error{ErrorCode::Limit,
                     context.name() + " has bricks more than " + std::to_string(kMaxNumber) +
                         " courses, columns or rows from its origin: increase their size, or move the origin closer."};
    }
    std::vector<IndexedPlace> places;
    std::size_t round = 0;
    for (int row = static_cast<int>(firstRow); row <= static_cast<int>(lastRow); ++row) {
        for (int course = bottom; course <= top; ++course) {
            const int end = courses.columnAt(course, box.max.x);
            for (int column = courses.columnAt(course, box.min.x); column <= end; ++column) {
                if (context.isCancelledAt(round++)) return TaskContext::cancelled();
                if (places.size() >= kMaxSeeds - seeds.size()) return tooManySeeds(context);
                const double left = courses.left(course, column), right = courses.left(course, column + 1);
                const Vec3 size(right - left, height + mortar, pitch);
                const Vec3 middle((left + right) / 2.0, courses.bottom(course) + size.y / 2.0,
                                  originHeight + (row + 0.5) * pitch);
                if (context.domain.depth(middle) < -glm::length(size) / 2.0) continue;  // none of it is in the mesh
                places.push_back({tripleIndex(zigzag(column), zigzag(course), zigzag(row)), middle});
            }
        }
    }
    addByIndex(places, context, seeds);
    return success();
}

double BrickBond::estimatedPiecesIn(const SolidDomain& domain) const {
    return estimatedPieces(domain.volume() / (depth + mortar));
}

}  // namespace rubble
