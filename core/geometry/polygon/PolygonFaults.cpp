#include "core/geometry/polygon/PolygonFaults.h"

#include "core/base/MessageText.h"
#include "core/geometry/polygon/NarrowFeatures.h"
#include "core/geometry/polygon/RingArrangement.h"
#include "core/geometry/predicates/Predicates.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace rubble {

namespace {

std::string ringName(int ring) { return ring == 0 ? "the outline" : "hole " + std::to_string(ring - 1); }

std::string sentence(std::string text) {
    if (text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text + ".";
}

std::string at(Vec2 point) { return "(" + messageText(point.x) + ", " + messageText(point.y) + ")"; }

/// Rounded, for computed points, which are not in the input.
std::string roundedAt(Vec2 point) {
    constexpr int kDigits = 6;  // resolve a millimetre of a kilometre
    return "(" + roundedText(point.x, kDigits) + ", " + roundedText(point.y, kDigits) + ")";
}

PolygonFault pointFault(PolygonFaultKind kind, RingPoint point, Vec2 where, std::string text) {
    return {kind, point, point, where, sentence(std::move(text))};
}

/// Faults of single points of a ring.
void findPointFaults(const Ring& ring, int number, std::vector<PolygonFault>& faults) {
    const std::string name = ringName(number);
    for (int i = 0; i < std::ssize(ring); ++i) {
        const Vec2 point = ring[i];
        const std::string which = "point " + std::to_string(i) + " of " + name;
        if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
            faults.push_back(pointFault(PolygonFaultKind::NotFinite, {number, i}, {0.0, 0.0},
                                        which + " is not a finite number: " + at(point)));
        } else if (!isExactlyUsable(point)) {
            faults.push_back(pointFault(PolygonFaultKind::OutOfRange, {number, i}, point,
                                        which + " is out of range: " + at(point) + "; a coordinate is zero or from " +
                                            messageText(kMinMagnitude) + " to " + messageText(kMaxMagnitude)));
        }
    }
    if (ring.size() < 3) {
        faults.push_back(pointFault(PolygonFaultKind::TooFewPoints, {number, 0}, {0.0, 0.0},
                                    name + " needs at least 3 points but has " + std::to_string(ring.size())));
    }
}

/// Faults of a ring of at least three usable points, other than crossings.
void findShapeFaults(const Ring& ring, int number, std::vector<PolygonFault>& faults) {
    const std::string name = ringName(number);
    const int count = static_cast<int>(std::ssize(ring));
    const std::size_t before = faults.size();
    for (int i = 0; i + 1 < count; ++i) {
        if (ring[i] != ring[i + 1]) continue;
        const std::string numbers = std::to_string(i) + " and " + std::to_string(i + 1);
        faults.push_back({PolygonFaultKind::RepeatedPoint,
                          {number, i},
                          {number, i + 1},
                          ring[i],
                          sentence("points " + numbers + " of " + name + " are equal: " + at(ring[i]))});
    }
    if (ring.front() == ring.back()) {
        faults.push_back({PolygonFaultKind::RepeatedPoint,
                          {number, count - 1},
                          {number, 0},
                          ring[0],
                          sentence("the last point of " + name + ", point " + std::to_string(count - 1) +
                                   ", repeats its first: " + at(ring[0]))});
    }
    if (faults.size() > before) return;
    const auto isOnLine = [&](Vec2 point) { return orient2d(ring[0], ring[1], point) == 0; };
    if (std::all_of(ring.begin(), ring.end(), isOnLine))
        faults.push_back(pointFault(PolygonFaultKind::ZeroArea, {number, 0}, ring[0],
                                    name + " encloses no area: all its points lie on one line"));
}

Vec2 crossingOf(const IndexedCorners& corners, std::uint32_t first, std::uint32_t second) {
    const Vec2 from = corners.points[first], direction = corners.points[corners.next[first]] - from;
    const Vec2 otherFrom = corners.points[second], otherDirection = corners.points[corners.next[second]] - otherFrom;
    const double along = cross(otherFrom - from, otherDirection) / cross(direction, otherDirection);
    return from + direction * std::clamp(along, 0.0, 1.0);
}

RingPoint ringPoint(const IndexedCorners& corners, std::uint32_t corner) {
    const std::uint32_t ring = corners.ring[corner];
    return {static_cast<int>(ring), static_cast<int>(corner - corners.firstOfRing[ring])};
}

std::string crossingText(RingPoint first, RingPoint second, Vec2 where) {
    const std::string a = std::to_string(first.point), b = std::to_string(second.point);
    const std::string name = ringName(first.ring);
    if (first.ring == second.ring)
        return name + " crosses itself between points " + a + " and " + b + ", at " + roundedAt(where);
    return name + " after its point " + a + " crosses " + ringName(second.ring) + " after its point " + b + ", at " +
           roundedAt(where);
}

std::string touchText(const IndexedCorners& corners, const BoundaryContact& contact) {
    const RingPoint first = ringPoint(corners, contact.first), second = ringPoint(corners, contact.second);
    const std::string a = std::to_string(first.point), b = std::to_string(second.point);
    const std::string name = ringName(first.ring), otherName = ringName(second.ring);
    const std::string place = ", at " + at(corners.points[contact.first]);
    if (contact.kind == BoundaryContact::Kind::CornersMeet) {
        if (first.ring == second.ring) return name + " touches itself: points " + a + " and " + b + " meet" + place;
        return name + " touches " + otherName + ": points " + a + " and " + b + " meet" + place;
    }
    const std::string end = std::to_string(ringPoint(corners, corners.next[contact.second]).point);
    const std::string edge = " lies on the edge from point " + b + " to " + end;
    if (first.ring == second.ring) return name + " touches itself: point " + a + edge + place;
    return "point " + a + " of " + name + edge + " of " + otherName + place;
}

PolygonFault faultOf(const IndexedCorners& corners, const BoundaryContact& contact) {
    const RingPoint first = ringPoint(corners, contact.first), second = ringPoint(corners, contact.second);
    if (contact.kind == BoundaryContact::Kind::EdgesCross) {
        const Vec2 where = crossingOf(corners, contact.first, contact.second);
        return {PolygonFaultKind::Crossing, first, second, where, sentence(crossingText(first, second, where))};
    }
    const Vec2 where = corners.points[contact.first];
    return {PolygonFaultKind::Touching, first, second, where, sentence(touchText(corners, contact))};
}

/// Holes that are not directly inside the outline.
void findNestingFaults(const Polygon& polygon, std::span<const std::uint32_t> parents,
                       std::vector<PolygonFault>& faults) {
    for (int ring = 1; ring < std::ssize(parents); ++ring) {
        const std::uint32_t parent = parents[ring];
        if (parent == 0) continue;
        const Vec2 where = polygon.holes[ring - 1][0];
        if (parent == kNone) {
            faults.push_back({PolygonFaultKind::HoleOutside,
                              {ring, 0},
                              {0, 0},
                              where,
                              sentence(ringName(ring) + " lies outside the outline")});
        } else {
            const int other = static_cast<int>(parent);
            faults.push_back({PolygonFaultKind::HolesOverlap,
                              {ring, 0},
                              {other, 0},
                              where,
                              sentence(ringName(ring) + " lies inside " + ringName(other))});
        }
    }
}

std::vector<PolygonFault> allFaults(const Polygon& polygon, std::size_t most) {
    std::vector<PolygonFault> faults;
    const int ringCount = 1 + static_cast<int>(std::ssize(polygon.holes));
    const auto ringOf = [&](int ring) -> const Ring& { return ring == 0 ? polygon.outer : polygon.holes[ring - 1]; };
    for (int ring = 0; ring < ringCount; ++ring) {
        const std::size_t before = faults.size();
        findPointFaults(ringOf(ring), ring, faults);
        if (faults.size() == before) findShapeFaults(ringOf(ring), ring, faults);
        if (faults.size() >= most) return faults;
    }
    if (!faults.empty()) return faults;

    const IndexedCorners corners = indexedCorners(polygon);
    const RingArrangement arrangement = ringArrangement(corners, most);
    for (const BoundaryContact& contact : arrangement.contacts) {
        faults.push_back(faultOf(corners, contact));
        if (faults.size() >= most) break;
    }
    findNestingFaults(polygon, arrangement.parent, faults);
    return faults;
}

std::string narrowText(const IndexedCorners& corners, const NarrowFeature& narrow, const Clearance& clearance) {
    const RingPoint first = ringPoint(corners, narrow.corner), second = ringPoint(corners, narrow.other);
    const std::string a = std::to_string(first.point), b = std::to_string(second.point);
    const std::string name = ringName(first.ring), where = ", at " + at(corners.points[narrow.corner]);
    const std::string distance = roundedText(clearance.distance, 2) + " m";
    switch (narrow.kind) {
        case NarrowFeature::Kind::ShortEdge:
            return "points " + a + " and " + b + " of " + name + " are nearer than " + distance + where +
                   ": leave one of them out";
        case NarrowFeature::Kind::SharpCorner:
            return name + " is too sharp at its point " + a + where + ": its edges must be more than " +
                   roundedText(clearance.sine, 2) + " rad apart";
        case NarrowFeature::Kind::CornerNearEdge: break;
    }
    const std::string end = std::to_string(ringPoint(corners, corners.next[narrow.other]).point);
    return "point " + a + " of " + name + " is nearer than " + distance + " to the edge from point " + b + " to " +
           end + " of " + ringName(second.ring) + where + ": move it away or leave it out";
}

ErrorCode codeOf(PolygonFaultKind kind) {
    switch (kind) {
        case PolygonFaultKind::NotFinite:
        case PolygonFaultKind::OutOfRange:
        case PolygonFaultKind::TooFewPoints:
        case PolygonFaultKind::RepeatedPoint: return ErrorCode::BadInput;
        case PolygonFaultKind::ZeroArea:
        case PolygonFaultKind::TooNear: return ErrorCode::Degenerate;
        case PolygonFaultKind::Crossing:
        case PolygonFaultKind::Touching:
        case PolygonFaultKind::HoleOutside:
        case PolygonFaultKind::HolesOverlap: return ErrorCode::Crossing;
    }
    return ErrorCode::BadInput;
}

}  // namespace

std::vector<PolygonFault> polygonFaults(const Polygon& polygon, int most) {
    const auto count = static_cast<std::size_t>(std::max(most, 1));
    std::vector<PolygonFault> faults = allFaults(polygon, count);
    if (faults.size() > count) faults.resize(count);
    return faults;
}

std::optional<PolygonFault> narrowFault(const Polygon& polygon) {
    const IndexedCorners corners = indexedCorners(polygon);
    const Clearance clearance = requiredClearance(polygon);
    const std::vector<NarrowFeature> features = narrowFeatures(corners, clearance);
    if (features.empty()) return std::nullopt;
    const NarrowFeature& first = features[0];
    return PolygonFault{PolygonFaultKind::TooNear, ringPoint(corners, first.corner), ringPoint(corners, first.other),
                        corners.points[first.corner], sentence(narrowText(corners, first, clearance))};
}

Result<Polygon> validated(Polygon polygon) {
    if (polygon.holes.empty() && isSimpleAndConvex(polygon.outer) &&
        hasAmpleClearance(polygon.outer, requiredClearance(polygon))) {
        return polygon;
    }
    const std::vector<PolygonFault> faults = polygonFaults(polygon);
    if (!faults.empty()) return Error{codeOf(faults[0].kind), faults[0].message};
    if (const std::optional<PolygonFault> fault = narrowFault(polygon))
        return Error{codeOf(fault->kind), fault->message};
    return withCanonicalWinding(std::move(polygon));
}

}  // namespace rubble
