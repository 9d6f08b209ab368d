#include "core/asset/import/VertexSeeds.h"

#include "core/asset/project/Ranges.h"
#include "core/base/MessageText.h"
#include "core/fracture/pattern/Pattern.h"
#include "core/geometry/polygon/ContainmentIndex.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace rubble {
namespace {

std::string points(std::uint32_t count) { return std::to_string(count) + (count == 1 ? " point" : " points"); }

Vec2 project(FileAxis axis, Vec3 point) {
    switch (axis) {
        case FileAxis::X: return {-point.z, point.y};
        case FileAxis::Y: return {point.x, -point.z};
        case FileAxis::Z: break;
    }
    return Vec2{point};
}

/// All points projected, in the file's unit.
std::vector<Vec2> projectedPoints(const SourceScene& mesh, FileAxis axis) {
    std::vector<Vec2> projected;
    for (const SourceObject& object : mesh.objects) {
        for (const Vec3 point : object.points) projected.push_back(project(axis, point));
    }
    return projected;
}

/// Scales points uniformly and centres them to fit into a box.
void fit(std::vector<Vec2>& points, const Box2& into) {
    const Box2 from = boundsOf(points);
    const Vec2 size = from.size(), available = into.size();
    double scale = std::numeric_limits<double>::infinity();
    if (size.x > 0.0) scale = available.x / size.x;
    if (size.y > 0.0) scale = std::min(scale, available.y / size.y);
    if (!std::isfinite(scale)) scale = 1.0;  // a single point
    const Vec2 fromMiddle = (from.min + from.max) / 2.0, middle = (into.min + into.max) / 2.0;
    for (Vec2& point : points) {
        point = glm::clamp(middle + scale * (point - fromMiddle), into.min, into.max);  // rounding may move it outside
    }
}

}  // namespace

std::string VertexSeeds::omissionText() const {
    std::string text;
    if (outside > 0) text = points(outside) + " of the mesh outside the outline";
    if (duplicates > 0) text += (text.empty() ? "" : " and ") + points(duplicates) + " at the position of others";
    if (text.empty()) return text;
    return text + (outside + duplicates == 1 ? " was left out." : " were left out.");
}

Result<VertexSeeds> seedsAtVertices(const SourceScene& mesh, const VertexView& view, const Polygon& outline) {
    const double inFile = mesh.metresPerUnit > 0.0 ? mesh.metresPerUnit : 1.0;
    const double scale = view.metresPerUnit.value_or(inFile);
    if (!rangeOf(ProjectNumber::MetresPerUnit).contains(scale)) {
        return Error{ErrorCode::BadInput, "The unit is " + messageText(scale) + " m; it must be " +
                                              rangeText(rangeOf(ProjectNumber::MetresPerUnit)) + "."};
    }
    std::vector<Vec2> projected = projectedPoints(mesh, view.along);
    for (Vec2& point : projected) point *= scale;
    if (view.isFitted && !projected.empty()) fit(projected, boundsOf(outline.outer));
    VertexSeeds found;
    std::set<std::pair<double, double>> taken;
    const ContainmentIndex index(outline);
    for (const Vec2 position : projected) {
        if (index.of(position) == Containment::Outside) {
            ++found.outside;
        } else if (!taken.insert({position.x + 0.0, position.y + 0.0}).second) {  // -0 is 0
            ++found.duplicates;
        } else if (found.seeds.seeds.size() == kMaxSeeds) {
            return Error{ErrorCode::Limit,
                         "The mesh has more than " + std::to_string(kMaxSeeds) + " points in the outline."};
        } else {
            found.seeds.seeds.push_back({static_cast<std::uint32_t>(found.seeds.seeds.size()), position});
        }
    }
    if (found.seeds.seeds.empty()) return Error{ErrorCode::Degenerate, "No point of the mesh lies in the outline."};
    return found;
}

}  // namespace rubble
