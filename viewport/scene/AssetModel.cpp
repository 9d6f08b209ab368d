#include "viewport/scene/AssetModel.h"

#include "core/asset/PieceColours.h"

namespace rubble {
namespace {

/// Whether a fragment is drawn, and not its parent or its children in its place.
bool isShown(const BakedFragment& fragment, std::uint32_t level) {
    return fragment.level == level || (fragment.level < level && fragment.childCount == 0);
}

/// A model while it is made.
class ModelBuilder {
public:
    ModelBuilder(AssetModel model, bool hasHulls)
        : m_model(std::move(model)),
          m_geometry(std::make_shared<SceneGeometry>()),
          m_hulls(hasHulls ? std::make_shared<SceneGeometry>() : nullptr) {}

    void addFragment(std::uint32_t number, const BakedFragment& fragment) {
        const Fragment& solid = fragment.solid;
        const Colour colour = pieceColour(m_model.bake->fragmentId(number));
        m_model.pieces.push_back({number, solid.offset(), solid.volume(), colour});
        addPiece(*m_geometry, fragmentMesh(fragment, m_model.asset));
        if (m_hulls) addPiece(*m_hulls, solid.hulls());
    }

    /// `offset`: of the piece's frame in the prism's.
    void addWhole(const Bake& bake, Vec3 offset) {
        const Vec3 centre = bake.whole.centre - offset;
        Mesh mesh = wholeMesh(bake, m_model.asset);
        for (Vec3& position : mesh.positions) position += centre;
        const Colour colour = pieceColour(std::to_string(m_model.asset.id));
        m_model.pieces.push_back({kNone, offset, bake.whole.volume, colour});
        addPiece(*m_geometry, mesh);
        if (!m_hulls) return;
        std::vector<Polytope> hulls = bake.wholeHulls;
        for (Polytope& hull : hulls) hull = translated(std::move(hull), centre);
        addPiece(*m_hulls, hulls);
    }

    AssetModel finished() {
        m_model.geometry = std::move(m_geometry);
        m_model.hulls = std::move(m_hulls);
        return std::move(m_model);
    }

private:
    AssetModel m_model;
    std::shared_ptr<SceneGeometry> m_geometry;
    std::shared_ptr<SceneGeometry> m_hulls;
};

/// The asset with nothing to break it.
Asset unbroken(Asset asset) {
    asset.pattern.layers.clear();
    asset.levels.clear();
    return asset;
}

}  // namespace

AssetModel modelOf(const Asset& asset, std::shared_ptr<const Bake> bake, const SceneOptions& options) {
    ModelBuilder builder({.asset = asset, .bake = bake, .level = options.level}, options.hasHulls);
    if (bake == nullptr) {
        const Result<Bake> whole = rubble::bake(unbroken(asset));
        if (whole) builder.addWhole(*whole, whole->whole.centre);
        return builder.finished();
    }
    for (std::uint32_t k = 0; k < bake->fragmentCount(); ++k) {
        const BakedFragment fragment = bake->fragment(k);
        if (isShown(fragment, options.level)) builder.addFragment(k, fragment);
    }
    return builder.finished();
}

AssetModel playModelOf(const Asset& asset, std::shared_ptr<const Bake> bake, const SceneOptions& options) {
    ModelBuilder builder({.asset = asset, .bake = bake}, options.hasHulls);
    builder.addWhole(*bake, Vec3(0.0));
    for (std::uint32_t k = 0; k < bake->fragmentCount(); ++k) builder.addFragment(k, bake->fragment(k));
    return builder.finished();
}

}  // namespace rubble
