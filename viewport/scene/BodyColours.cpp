#include "viewport/scene/BodyColours.h"

#include "core/asset/project/FragmentColours.h"
#include "core/asset/project/Threshold.h"
#include "core/asset/strength/FragmentThreshold.h"
#include "core/asset/strength/Threshold.h"
#include "core/asset/project/Variants.h"
#include "core/play/scene/PlayAsset.h"

#include <algorithm>

namespace rubble {
namespace {

/// The material that the asset has in the project now: the model may be older.
const Material* materialOf(const AssetModel& model, const Project& project) {
    const Asset* asset = findAsset(project, model.asset.id);
    return findMaterial(project, asset != nullptr ? asset->material : model.asset.material);
}

/// The material of the cut faces; null if it is that of the asset.
const Material* insideOf(const AssetModel& model, const Project& project) {
    const Asset* asset = findAsset(project, model.asset.id);
    return findMaterial(project, asset != nullptr ? asset->insideMaterial : model.asset.insideMaterial);
}

bool isQuantity(SceneColouring colouring) {
    return colouring != SceneColouring::Material && colouring != SceneColouring::Piece;
}

double thresholdOf(const Project& project, const AssetModel& model, Id instance) {
    if (project.damage.isThesis) return project.damage.thesisThreshold;
    const auto placed = std::ranges::find(project.instances, instance, &Instance::id);
    if (placed != project.instances.end() && placed->threshold) return *placed->threshold;
    const Asset* asset = findAsset(project, model.asset.id);
    return asset != nullptr ? rubble::thresholdOf(project, *asset) : model.asset.threshold;
}

/// Evaluates the quantity that the pieces of one instance are coloured by.
class PieceQuantity {
public:
    PieceQuantity(const Project& project, const AssetModel& model, Id instance, SceneColouring colouring)
        : m_colouring(colouring) {
        if (colouring == SceneColouring::Threshold) {
            m_factor = thresholdOf(project, model, instance);
            keepThresholds(project, model);
        }
        if (colouring != SceneColouring::Mass) return;
        const Material* material = materialOf(model, project);
        m_factor = material != nullptr ? material->density : 0.0;
    }

    double of(const ModelPiece& piece) const {
        switch (m_colouring) {
            case SceneColouring::Level: return piece.level;
            case SceneColouring::Volume: return piece.volume;
            case SceneColouring::Mass: return piece.volume * m_factor;
            case SceneColouring::Aspect: return piece.aspect;
            case SceneColouring::Threshold: return thresholdOfParent(piece);
            case SceneColouring::Material:
            case SceneColouring::Piece: break;
        }
        return 0.0;
    }

private:
    /// Keeps the asset as it is now if it sets thresholds of fragments.
    void keepThresholds(const Project& project, const AssetModel& model) {
        const Asset* asset = findAsset(project, model.asset.id);
        if (asset == nullptr || model.bake == nullptr || project.damage.isThesis) return;
        const auto isSet = [](const Level& level) { return level.threshold.has_value(); };
        const auto isLeafSet = [&](const FragmentLevel& leaf) { return leaf.level && isSet(*leaf.level); };
        if (asset->fragmentThresholds.empty() && std::ranges::none_of(asset->levels, isSet) &&
            std::ranges::none_of(asset->leaves, isLeafSet)) {
            return;
        }
        m_asset = variantOf(*asset, model.variant);
        m_bake = model.bake;
    }

    /// The threshold of what breaks into the piece.
    double thresholdOfParent(const ModelPiece& piece) const {
        if (m_asset && piece.parent != kNone) {
            const FragmentPath path = pathOfId(m_bake->fragmentId(piece.parent));
            if (const std::optional<double> set = fragmentThreshold(*m_asset, path, levelOf(path))) return *set;
        }
        return thresholdScaleOf(piece.parentVolumeFraction) * m_factor;
    }

    SceneColouring m_colouring;
    double m_factor = 1.0;
    std::optional<Asset> m_asset;  // none: no fragment has a threshold that is set
    std::shared_ptr<const Bake> m_bake;
};

/// Calls visit(model, instance, first body) for each instance in a scene.
template <class Visit>
void forEachInstance(const RenderScene& scene, std::span<const AssetModel* const> models, Visit visit) {
    for (std::size_t k = 0; k < models.size(); ++k) {
        for (const std::uint32_t first : scene.batches[k].firstBodies) {
            visit(*models[k], scene.picks[first].instance, first);
        }
    }
}

ValueRange rangeOf(const RenderScene& scene, std::span<const AssetModel* const> models, const Project& project,
                   SceneColouring colouring) {
    ValueRange range{1e308, 0.0};
    forEachInstance(scene, models, [&](const AssetModel& model, Id instance, std::uint32_t) {
        const PieceQuantity quantity(project, model, instance, colouring);
        for (const ModelPiece& piece : model.pieces) {
            const double value = quantity.of(piece);
            range = {std::min(range.least, value), std::max(range.most, value)};
        }
    });
    return range;
}

}  // namespace

void colourBodies(RenderScene& scene, std::span<const AssetModel* const> models, const Project& project,
                  SceneColouring colouring) {
    scene.colourRange.reset();
    const bool isOnRamp = isQuantity(colouring) && !scene.picks.empty();
    if (isOnRamp) scene.colourRange = rangeOf(scene, models, project, colouring);
    const auto fractionOf = [&](double value) {
        const double spread = scene.colourRange->most - scene.colourRange->least;
        return spread > 0.0 ? (value - scene.colourRange->least) / spread : 0.5;
    };
    forEachInstance(scene, models, [&](const AssetModel& model, Id instance, std::uint32_t first) {
        const PieceQuantity quantity(project, model, instance, colouring);
        const Material* material = colouring == SceneColouring::Material ? materialOf(model, project) : nullptr;
        const Material* cutMaterial = material != nullptr ? insideOf(model, project) : nullptr;
        for (std::uint32_t piece = 0; piece < model.pieces.size(); ++piece) {
            const ModelPiece& shown = model.pieces[piece];
            const Colour outside = isOnRamp              ? rampColour(fractionOf(quantity.of(shown)))
                                   : material != nullptr ? material->outside
                                                         : shown.colour;
            const Material* cut = cutMaterial != nullptr ? cutMaterial : material;
            scene.appearances[first + piece].outside =
                packedSurface(outside, material != nullptr ? material->opacity : 1.0);
            scene.appearances[first + piece].inside =
                cut != nullptr ? packedSurface(cut->inside, cut->opacity) : packed(insideOf(outside));
        }
    });
}

}  // namespace rubble
