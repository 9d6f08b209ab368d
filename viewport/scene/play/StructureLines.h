#pragma once

#include "core/play/session/Session.h"
#include "core/structure/bonds/FaceEdges.h"
#include "viewport/scene/RenderScene.h"

#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace rubble {

/// Draws the bonds of a session in its scenes. Keeps the edges of the structures that it has drawn.
class StructureLines {
public:
    /// The body of a scene as which a fragment of a body of the session is drawn.
    using SolidOf = std::function<std::uint32_t(const PlayBody&, std::uint32_t fragment)>;

    /// Adds lines on the surface where bonds are damaged, darker and wider the more of them is gone, and where they are
    /// broken within a body.
    void addCracks(RenderScene& scene, const Session& session, const SolidOf& solidOf);
    /// Adds a line for every unbroken bond, from centre to centre, coloured by its damage as heatColour() has it; to an
    /// anchor, it ends at the face.
    void addBonds(RenderScene& scene, const Session& session, const SolidOf& solidOf) const;

private:
    const std::vector<FaceEdge>& edgesOf(const PlayStructure& structure);

    using Edges = std::vector<FaceEdge>;
    std::map<std::pair<const Bake*, std::uint32_t>, std::pair<std::shared_ptr<const Bake>, Edges>>
        m_edges;  // by parent
};

}  // namespace rubble
