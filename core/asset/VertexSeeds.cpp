#include "core/asset/VertexSeeds.h"

#include "core/base/MessageText.h"
#include "core/fracture/Pattern.h"

#include <cmath>
#include <set>

namespace rubble {
namespace {

std::string points(std::uint32_t count) { return std::to_string(count) + (count == 1 ? " point" : " points"); }

}  // namespace

std::string VertexSeeds::report() const {
    std::string text;
    if (outside > 0) text = points(outside) + " of the mesh outside the outline";
    if (duplicates > 0) text += (text.empty() ? "" : " and ") + points(duplicates) + " in the place of others";
    if (text.empty()) return text;
    return text + (outside + duplicates == 1 ? " was left out." : " were left out.");
}

Result<VertexSeeds> seedsAtVertices(const SourceScene& mesh, double scale, const Polygon& outline) {
    if (!std::isfinite(scale) || scale <= 0.0) {
        return Error{ErrorCode::BadInput, "The mesh cannot be scaled by " + messageText(scale) + "."};
    }
    VertexSeeds found;
    std::set<std::pair<double, double>> taken;
    for (const SourceObject& object : mesh.objects) {
        for (const Vec3 point : object.points) {
            const Vec2 place = scale * Vec2{point};
            if (containment(outline, place) == Containment::Outside) {
                ++found.outside;
            } else if (!taken.insert({place.x + 0.0, place.y + 0.0}).second) {  // -0 is 0
                ++found.duplicates;
            } else if (found.seeds.seeds.size() == kMostSeeds) {
                return Error{ErrorCode::Limit,
                             "The mesh has more than " + std::to_string(kMostSeeds) + " points in the outline."};
            } else {
                found.seeds.seeds.push_back({static_cast<std::uint32_t>(found.seeds.seeds.size()), place});
            }
        }
    }
    if (found.seeds.seeds.empty()) return Error{ErrorCode::Degenerate, "No point of the mesh lies in the outline."};
    return found;
}

}  // namespace rubble
