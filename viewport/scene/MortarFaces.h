#pragma once

#include "core/asset/bake/Bake.h"
#include "viewport/scene/SceneGeometry.h"

#include <vector>

namespace rubble {

/// The mortar around the pieces of a pattern with joints, as far as it is drawn: none has a mass or collides.
class MortarFaces {
public:
    /// `asset`: of the bake.
    explicit MortarFaces(const Asset& asset);

    /// Whether the pattern has joints.
    bool isThere() const { return m_joint > 0.0; }
    /// The mortar that a fragment of the whole carries, in its frame: its cell, which half the joints around it belong
    /// to, a little behind the faces of the asset. Fragments of deeper levels have none. Faces are convex; the cut
    /// edges of cells that are not convex end at the outline without a face.
    std::vector<PlainFace> around(const BakedFragment& fragment) const;

private:
    double m_joint;   // m
    double m_recess;  // m
};

}  // namespace rubble
