#include "tests/oracle/RationalConvex.h"

#include <cmath>

namespace rubble::oracle {
namespace {

/// A lazy number rounded to double: from its interval if that is narrow enough, else from the exact rational.
double rounded(const Exact::FT& number) {
    constexpr double kNarrow = 1e-13;
    const CGAL::Interval_nt<false>& interval = number.approx();
    const double width = interval.sup() - interval.inf();
    if (width <= kNarrow * std::min(std::abs(interval.inf()), std::abs(interval.sup())))
        return 0.5 * (interval.inf() + interval.sup());
    return CGAL::to_double(number.exact());
}

Point intersectionOf(const Line& one, const Line& other) {
    const auto intersection = CGAL::intersection(one, other);
    return *boost::get<Point>(&*intersection);
}

}  // namespace

bool Convex::liesOn(std::size_t side, const Line& line) const {
    return line.has_on(corners[side]) && line.has_on(end(side));
}

double Convex::lengthOf(std::size_t side) const {
    return std::sqrt(rounded(CGAL::squared_distance(corners[side], end(side))));
}

CGAL::Bbox_2 Convex::box() const {
    CGAL::Bbox_2 box;
    for (const Point& corner : corners) box += corner.bbox();
    return box;
}

Convex clipped(const Convex& region, const Side& cut) {
    const std::size_t count = region.corners.size();
    std::vector<CGAL::Oriented_side> where(count);
    bool isInside = false;
    bool isCut = false;
    for (std::size_t k = 0; k < count; ++k) {
        where[k] = cut.line.oriented_side(region.corners[k]);
        isInside |= where[k] == CGAL::ON_POSITIVE_SIDE;
        isCut |= where[k] == CGAL::ON_NEGATIVE_SIDE;
    }
    if (!isInside) return {};
    if (!isCut) return region;
    Convex part;
    const auto emit = [&](const Point& corner, const Side& side) {
        part.corners.push_back(corner);
        part.sides.push_back(side);
    };
    for (std::size_t k = 0; k < count; ++k) {
        const CGAL::Oriented_side from = where[k];
        const CGAL::Oriented_side to = where[(k + 1) % count];
        if (from == CGAL::ON_POSITIVE_SIDE) emit(region.corners[k], region.sides[k]);
        if (from == CGAL::ON_ORIENTED_BOUNDARY)
            emit(region.corners[k], to == CGAL::ON_NEGATIVE_SIDE ? cut : region.sides[k]);
        if (from == CGAL::ON_POSITIVE_SIDE && to == CGAL::ON_NEGATIVE_SIDE)
            emit(intersectionOf(region.sides[k].line, cut.line), cut);
        if (from == CGAL::ON_NEGATIVE_SIDE && to == CGAL::ON_POSITIVE_SIDE)
            emit(intersectionOf(region.sides[k].line, cut.line), region.sides[k]);
    }
    return part;
}

double areaOf(const Convex& region) {
    double area = 0.0;
    for (std::size_t k = 2; k < region.corners.size(); ++k)
        area += rounded(CGAL::area(region.corners[0], region.corners[k - 1], region.corners[k]));
    return area;
}

double perimeterOf(const Convex& region) {
    double perimeter = 0.0;
    for (std::size_t k = 0; k < region.corners.size(); ++k) perimeter += region.lengthOf(k);
    return perimeter;
}

Vec2 momentOf(const Convex& region, const Point& origin) {
    Vec2 moment{0.0, 0.0};
    std::vector<Vec2> local;
    for (const Point& corner : region.corners)
        local.emplace_back(rounded(corner.x() - origin.x()), rounded(corner.y() - origin.y()));
    for (std::size_t k = 2; k < local.size(); ++k) {
        const double area = rounded(CGAL::area(region.corners[0], region.corners[k - 1], region.corners[k]));
        moment += area / 3.0 * (local[0] + local[k - 1] + local[k]);
    }
    return moment;
}

}  // namespace rubble::oracle
