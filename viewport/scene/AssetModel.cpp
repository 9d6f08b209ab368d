#include "viewport/scene/AssetModel.h"

#include "core/asset/mesh/FragmentMesh.h"
#include "core/asset/mesh/RoughCuts.h"
#include "core/asset/project/FragmentColours.h"
#include "core/geometry/hull/AspectRatio.h"
#include "core/structure/bonds/Bond.h"
#include "viewport/scene/MortarFaces.h"

namespace rubble {
namespace {

/// Whether a fragment itself is drawn at a level, rather than its parent or its children.
bool isShown(const BakedFragment& fragment, std::uint32_t level) {
    return fragment.level == level || (fragment.level < level && fragment.childCount == 0);
}

/// The bonds between the solids of a model of a bake, each once.
std::vector<ModelBond> bondsOfModel(const AssetModel& model) {
    std::vector<ModelBond> bonds;
    std::vector<std::uint32_t> solidOf(model.bake->fragmentCount(), kNone);
    for (std::uint32_t solid = 0; solid < model.solids.size(); ++solid) {
        if (model.solids[solid].fragment != kNone) solidOf[model.solids[solid].fragment] = solid;
    }
    for (std::uint32_t k = 0; k < model.bake->fractures.size(); ++k) {
        const BakedFracture& fracture = model.bake->fractures[k];
        for (const Bond& bond : bondsOf(fracture.fragments)) {
            const std::uint32_t first = solidOf[fracture.first + bond.first];
            const std::uint32_t second = solidOf[fracture.first + bond.second];
            if (first != kNone && second != kNone) bonds.push_back({first, second, k, bond.area, Vec2(bond.centroid)});
        }
    }
    return bonds;
}

/// An AssetModel under construction.
class ModelBuilder {
public:
    ModelBuilder(AssetModel model, const SceneOptions& options)
        : m_model(std::move(model)),
          m_mesher(m_model.asset),
          m_mortar(m_model.asset),
          m_geometry(std::make_shared<SceneGeometry>()),
          m_hulls(options.hasHulls ? std::make_shared<SceneGeometry>() : nullptr),
          m_hasBonds(needBonds(options)) {}

    /// Makes room for the fragments of one level, so that they are not moved while others are added. Each corner of a
    /// fragment is a vertex of two fans and of two quads.
    void reserve(const Fragments& fragments) {
        const ExtrudedPieces* pieces = fragments.extruded();
        if (!pieces) return;
        const std::size_t corners = pieces->partition.corners.size(), count = pieces->partition.pieceCount();
        m_geometry->vertices.reserve(m_geometry->vertices.size() + 6 * corners + 2 * count);
        m_geometry->indices.reserve(m_geometry->indices.size() + 12 * corners);
        m_geometry->boxes.reserve(m_geometry->boxes.size() + count);
        m_model.solids.reserve(m_model.solids.size() + count);
    }

    void addFragment(std::uint32_t number, const BakedFragment& fragment, const RoughCuts& cuts) {
        const Fragment& solid = fragment.solid;
        const Colour colour = fragmentColour(m_model.bake->fragmentId(number));
        const double parent = fragment.parent == kNone ? m_model.bake->whole.volume
                                                       : m_model.bake->fragment(fragment.parent).solid.volume();
        m_model.solids.push_back({.fragment = number,
                                  .offset = solid.offset(),
                                  .volume = solid.volume(),
                                  .parent = fragment.parent,
                                  .parentVolumeFraction = parent / m_model.bake->whole.volume,
                                  .aspect = solid.aspectRatio(),
                                  .level = fragment.level,
                                  .colour = colour});
        const SolidPart part{m_mesher.fragmentMesh(fragment, cuts.cornersOf(number)), m_mortar.around(fragment),
                             isRough()};
        addSolid(*m_geometry, {&part, 1}, texture());
        if (m_hulls) addSolid(*m_hulls, solid.hulls());
    }

    /// `offset`: origin of the solid's frame in the prism's frame. An asset with joints has them from the start.
    void addWhole(const Bake& bake, Vec3 offset, const RoughCuts* cuts = nullptr) {
        const Colour colour = fragmentColour(std::to_string(m_model.asset.id));
        m_model.solids.push_back(
            {.offset = offset, .volume = bake.whole.volume, .aspect = wholeAspect(bake), .colour = colour});
        addSolid(*m_geometry, wholeParts(bake, offset, cuts), texture());
        if (!m_hulls) return;
        const Vec3 centre = bake.whole.centre - offset;
        std::vector<Polytope> hulls = bake.wholeHulls;
        for (Polytope& hull : hulls) hull = translated(std::move(hull), centre);
        addSolid(*m_hulls, hulls);
    }

    /// The whole is solid 0.
    void endWhole() { rubble::endWhole(*m_geometry); }

    /// Adds what is seen of the whole without joints. `isDouble`: the whole is no solid of its own.
    void addSilhouette(const Bake& bake, Vec3 offset, bool isDouble) {
        addSolid(*m_geometry, wholeParts(bake, offset, nullptr), texture());
        endSilhouette(*m_geometry, isDouble ? SceneGeometry::Whole::Double : SceneGeometry::Whole::None);
    }
    bool hasJoints() const { return m_mortar.isThere(); }

    AssetModel finished() {
        m_model.geometry = std::move(m_geometry);
        m_model.hulls = std::move(m_hulls);
        if (m_hasBonds && m_model.bake)
            m_model.bonds = std::make_shared<const std::vector<ModelBond>>(bondsOfModel(m_model));
        return std::move(m_model);
    }

private:
    double wholeAspect(const Bake& bake) const {
        return m_model.asset.isPrism() ? aspectRatio(m_model.asset.prism().outline) : aspectRatio(bake.whole);
    }
    /// The whole, or if there is mortar its fragments with it, in a frame at `offset`.
    std::vector<SolidPart> wholeParts(const Bake& bake, Vec3 offset, const RoughCuts* cuts) const {
        if (cuts != nullptr && m_mortar.isThere()) return partsWithin(bake, offset, *cuts);
        std::vector<SolidPart> parts{{m_mesher.wholeMesh(bake), {}}};
        for (Vec3& position : parts[0].mesh.positions) position += bake.whole.centre - offset;
        return parts;
    }
    /// The fragments of the whole with their mortar, in a frame at `offset`.
    std::vector<SolidPart> partsWithin(const Bake& bake, Vec3 offset, const RoughCuts& cuts) const {
        std::vector<SolidPart> parts;
        for (std::uint32_t k = 0; k < bake.fragmentCount(); ++k) {
            const BakedFragment fragment = bake.fragment(k);
            if (fragment.level > 0) break;  // the others are deeper
            const Vec3 shift = fragment.solid.offset() - offset;
            SolidPart part{m_mesher.fragmentMesh(fragment, cuts.cornersOf(k)), m_mortar.around(fragment), isRough()};
            for (Vec3& position : part.mesh.positions) position += shift;
            for (PlainFace& face : part.mortar) {
                for (Vec3& corner : face.corners) corner += shift;
            }
            parts.push_back(std::move(part));
        }
        return parts;
    }
    bool isRough() const { return m_model.asset.shaping.roughness.amplitude > 0.0; }
    const Texture* texture() const { return m_model.asset.texture ? &*m_model.asset.texture : nullptr; }

    AssetModel m_model;
    FragmentMesher m_mesher;
    MortarFaces m_mortar;
    std::shared_ptr<SceneGeometry> m_geometry;
    std::shared_ptr<SceneGeometry> m_hulls;
    bool m_hasBonds;
};

/// The asset without a pattern.
Asset unbroken(Asset asset) {
    asset.pattern.layers.clear();
    asset.levels.clear();
    return asset;
}

}  // namespace

bool needBonds(const SceneOptions& options) {
    return options.hasBonds || options.colouring == SceneColouring::BondStrength;
}

SceneBatch batchOf(const AssetModel& model, const SceneOptions& options) {
    const bool isTextured = model.asset.texture && options.colouring == SceneColouring::Material;
    return {.geometry = model.geometry,
            .hulls = options.hasHulls ? model.hulls : nullptr,
            .firstBodies = {},
            .texture = isTextured ? model.asset.texture->image : nullptr};
}

AssetModel modelOf(const Asset& asset, std::shared_ptr<const Bake> bake, const SceneOptions& options) {
    ModelBuilder builder({.asset = asset, .bake = bake, .level = options.level}, options);
    if (bake == nullptr) {
        const Result<Bake> whole = rubble::bake(unbroken(asset));
        if (whole) builder.addWhole(*whole, whole->whole.centre);
        return builder.finished();
    }
    const RoughCuts cuts(*bake, asset);
    std::vector<std::uint32_t> shown;
    for (std::uint32_t k = 0; k < bake->fragmentCount(); ++k)
        if (isShown(bake->fragment(k), options.level)) shown.push_back(k);
    if (bake->fractures.size() == 1) builder.reserve(bake->fractures.front().fragments);
    if (shown.size() > 1) builder.addSilhouette(*bake, bake->fragment(shown.front()).solid.offset(), true);
    for (const std::uint32_t k : shown) builder.addFragment(k, bake->fragment(k), cuts);
    return builder.finished();
}

AssetModel playModelOf(const Asset& asset, std::shared_ptr<const Bake> bake, const SceneOptions& options) {
    ModelBuilder builder({.asset = asset, .bake = bake}, options);
    const RoughCuts cuts(*bake, asset);
    if (builder.hasJoints()) builder.addSilhouette(*bake, Vec3(0.0), false);
    builder.addWhole(*bake, Vec3(0.0), &cuts);
    builder.endWhole();
    for (std::uint32_t k = 0; k < bake->fragmentCount(); ++k) builder.addFragment(k, bake->fragment(k), cuts);
    return builder.finished();
}

}  // namespace rubble
