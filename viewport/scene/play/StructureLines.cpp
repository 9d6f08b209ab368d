#include "viewport/scene/play/StructureLines.h"

#include "viewport/scene/play/OverlayColours.h"

#include <algorithm>
#include <array>

namespace rubble {
namespace {

// Radii in points, colours in sRGB.
constexpr glm::vec3 kCrack{0.07f, 0.06f, 0.05f};
constexpr float kThinnestCrack = 0.35f, kWidestCrack = 0.9f;
constexpr float kFaintestCrack = 0.35f, kDarkestCrack = 0.9f;
constexpr float kIntactBond = 0.9f, kDamagedBond = 3.0f, kBondOpacity = 0.95f;

/// Where the points of a structure are in a scene, as parts of one of its bodies.
class StructureFrame {
public:
    /// `solid`: the body of the scene.
    StructureFrame(const RenderScene& scene, const Session& session, const PlayBody& body, std::uint32_t solid)
        : m_scene(scene), m_pose(session.world().state(body.body).pose), m_frame(frameOf(body)), m_solid(solid) {}

    Vec3 inWorld(Vec3 point) const { return m_pose.position + m_pose.orientation * (point - m_frame); }

    SceneLine line(Vec3 from, Vec3 to, float radius, LineEnd end, glm::vec4 colour) const {
        const Vec3 a = inWorld(from), b = inWorld(to);
        return {glm::vec4(glm::vec3(a - m_scene.origin), radius),
                glm::vec4(glm::vec3(b - m_scene.origin), static_cast<float>(end)), colour,
                glm::vec4(previousOffset(glm::vec3(0.5 * (a + b) - m_scene.origin)), 0.0f)};
    }

private:
    /// The position of a point one step earlier minus its position now.
    glm::vec3 previousOffset(glm::vec3 point) const {
        if (m_scene.previousPoses.empty()) return glm::vec3(0.0f);
        const RenderPose &now = m_scene.poses[m_solid], &then = m_scene.previousPoses[m_solid];
        if (now == then) return glm::vec3(0.0f);
        const auto orientationOf = [](const RenderPose& pose) {
            return glm::quat(pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z);
        };
        const glm::vec3 inSolid = glm::conjugate(orientationOf(now)) * (point - glm::vec3(now.position));
        return glm::vec3(then.position) + orientationOf(then) * inSolid - point;
    }

    const RenderScene& m_scene;
    Pose m_pose;
    Vec3 m_frame;
    std::uint32_t m_solid;
};

glm::vec4 crackColour(float fraction) { return glm::vec4(kCrack, glm::mix(kFaintestCrack, kDarkestCrack, fraction)); }

glm::vec4 damageColour(BondDamage damage) {
    const Colour colour = heatColour(static_cast<double>(damage) / kBroken);
    return {static_cast<float>(colour.red), static_cast<float>(colour.green), static_cast<float>(colour.blue),
            kBondOpacity};
}

/// The structure of a body with bonds, of which none may be damaged yet; null if it has none.
const PlayStructure* structureOf(const Session& session, const PlayBody& body) {
    if (body.bondedFracture() == nullptr) return nullptr;
    if (body.structure != kNone) return session.structures()[body.structure].structure.get();
    const PlayScene& scene = session.scene();
    const PlayOrigin& origin = session.origins()[body.origin];
    const auto own = scene.structures.find(origin.instance);
    if (body.fragment == kNone && own != scene.structures.end()) return own->second.get();
    const auto structures = scene.assetStructures.find({origin.asset, origin.variant});
    if (structures == scene.assetStructures.end()) return nullptr;
    const auto found = structures->second.find(body.fragment);
    return found != structures->second.end() ? found->second.get() : nullptr;
}

const Fragments& fragmentsOf(const PlayStructure& structure) {
    return structure.asset->bake->fractureOf(structure.parent)->fragments;
}

/// The lines of a crack through an edge: along it on both faces, and through the depth where it meets the outline.
std::vector<std::array<Vec3, 2>> crackLines(const FaceEdge& edge, const Fragments& fragments) {
    const auto at = [&](Vec2 point, double side) {
        return Vec3(point, 0.5 * side * fragments.extruded()->depth) + fragments.origin;
    };
    std::vector<std::array<Vec3, 2>> lines;
    for (const double side : {-1.0, 1.0}) lines.push_back({at(edge.from, side), at(edge.to, side)});
    if (edge.startsOutside) lines.push_back({at(edge.from, -1.0), at(edge.from, 1.0)});
    if (edge.endsOutside) lines.push_back({at(edge.to, -1.0), at(edge.to, 1.0)});
    return lines;
}

}  // namespace

const std::vector<FaceEdge>& StructureLines::edgesOf(const PlayStructure& structure) {
    const std::shared_ptr<const Bake>& bake = structure.asset->bake;
    auto& [kept, edges] = m_edges[{bake.get(), structure.parent}];
    if (kept == nullptr) {
        kept = bake;
        edges = faceEdges(fragmentsOf(structure), bondsOf(fragmentsOf(structure)));
    }
    return edges;
}

void StructureLines::addCracks(RenderScene& scene, const Session& session, const SolidOf& solidOf) {
    for (const StructureState& state : session.structures()) {
        const std::vector<Bond>& bonds = state.structure->graph.bonds;
        for (const FaceEdge& edge : edgesOf(*state.structure)) {
            const BondDamage damage = state.damage[edge.bond];
            const std::uint32_t first = bonds[edge.bond].first, number = state.bodyOfNode[first];
            if (damage == kIntact || number == kNone || number != state.bodyOfNode[bonds[edge.bond].second]) continue;
            const PlayBody* const body = session.body(number);  // null: it was removed as debris
            if (body == nullptr || session.fadeOf(*body) > 0.0) continue;
            const float fraction = static_cast<float>(damage) / kBroken;
            const float radius = glm::mix(kThinnestCrack, kWidestCrack, fraction);
            const StructureFrame frame(scene, session, *body, solidOf(*body, state.structure->fragmentOf(first)));
            for (const auto& [from, to] : crackLines(edge, fragmentsOf(*state.structure)))
                scene.lines.push_back(frame.line(from, to, radius, LineEnd::OnSurface, crackColour(fraction)));
        }
    }
}

void StructureLines::addBonds(RenderScene& scene, const Session& session, const SolidOf& solidOf) const {
    for (const PlayBody& body : session.bodies()) {
        const PlayStructure* structure = structureOf(session, body);
        if (structure == nullptr || session.fadeOf(body) > 0.0) continue;
        const StructureState* state = body.structure != kNone ? &session.structures()[body.structure] : nullptr;
        const std::uint32_t node = body.nodes.empty() ? 0 : body.nodes.front();
        const StructureFrame frame(scene, session, body, solidOf(body, structure->fragmentOf(node)));
        const BondGraph& graph = structure->graph;
        for (std::uint32_t k = 0; k < graph.bondCount(); ++k) {
            const Bond& bond = graph.bonds[k];
            const BondDamage damage = state != nullptr ? state->damage[k] : kIntact;
            const bool isOfBody = state == nullptr || state->bodyOfNode[bond.first] == body.number;
            if (damage == kBroken || !isOfBody) continue;
            const float radius = glm::mix(kIntactBond, kDamagedBond, static_cast<float>(damage) / kBroken);
            const Vec3 end = bond.second != kNone ? graph.centres[bond.second] : bond.centroid;
            scene.lines.push_back(
                frame.line(graph.centres[bond.first], end, radius, LineEnd::Round, damageColour(damage)));
        }
    }
}

}  // namespace rubble
