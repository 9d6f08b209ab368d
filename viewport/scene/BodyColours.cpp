#include "viewport/scene/BodyColours.h"

#include "core/asset/project/FragmentColours.h"
#include "core/asset/project/Variants.h"
#include "core/asset/strength/FragmentThresholds.h"
#include "core/asset/strength/Threshold.h"
#include "core/play/scene/PlayAsset.h"
#include "core/structure/clusters/ClusterColours.h"
#include "viewport/scene/BondStrengths.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace rubble {
namespace {

constexpr Colour kWithoutValue{0.66, 0.66, 0.66};
constexpr Colour kNeverBreaks{0.52, 0.27, 0.72};

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
    return colouring != SceneColouring::Material && colouring != SceneColouring::Fragment &&
           colouring != SceneColouring::Cluster;
}

double thresholdOf(const Project& project, const AssetModel& model, Id instance) {
    if (project.damage.isThesis) return project.damage.thesisThreshold;
    const Instance* placed = findInstance(project, instance);
    if (placed != nullptr && placed->threshold) return *placed->threshold;
    const Asset* asset = findAsset(project, model.asset.id);
    return asset != nullptr ? rubble::thresholdOf(project, *asset) : model.asset.threshold;
}

/// Evaluates the quantity that the solids of one instance are coloured by.
class SolidQuantity {
public:
    SolidQuantity(const Project& project, const AssetModel& model, Id instance, SceneColouring colouring)
        : m_colouring(colouring) {
        if (colouring == SceneColouring::Threshold) {
            m_factor = thresholdOf(project, model, instance);
            keepThresholds(project, model);
        }
        if (colouring == SceneColouring::BondStrength) {
            const Instance* placed = findInstance(project, instance);
            if (placed != nullptr) m_factor = placed->bondStrength;
            m_strengths = bondStrengths(model, project);
        }
        if (colouring != SceneColouring::Mass) return;
        const Material* material = materialOf(model, project);
        m_factor = material != nullptr ? material->density : 0.0;
    }

    /// NaN: it has no value.
    double of(const AssetModel& model, std::size_t index) const {
        const ModelSolid& solid = model.solids[index];
        switch (m_colouring) {
            case SceneColouring::Level: return solid.level;
            case SceneColouring::Volume: return solid.volume;
            case SceneColouring::Mass: return solid.volume * m_factor;
            case SceneColouring::Aspect: return solid.aspect;
            case SceneColouring::Threshold: return thresholdOfParent(solid);
            case SceneColouring::BondStrength: return m_factor * m_strengths[index];
            case SceneColouring::Material:
            case SceneColouring::Fragment:
            case SceneColouring::Cluster: break;
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
            std::ranges::none_of(asset->fragmentLevels, isLeafSet)) {
            return;
        }
        m_asset = variantOf(*asset, model.variant);
        m_bake = model.bake;
    }

    /// The threshold of what breaks into the solid.
    double thresholdOfParent(const ModelSolid& solid) const {
        if (m_asset && solid.parent != kNone) {
            const FragmentPath path = m_bake->fragmentPath(solid.parent);
            if (const std::optional<double> set = fragmentThreshold(*m_asset, path, levelOf(path))) return *set;
        }
        return thresholdScaleOf(solid.parentVolumeFraction) * m_factor;
    }

    SceneColouring m_colouring;
    double m_factor = 1.0;
    std::optional<Asset> m_asset;  // none: no fragment has a threshold that is set
    std::shared_ptr<const Bake> m_bake;
    std::vector<double> m_strengths;  // of bonds, of each solid
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

/// Nothing if no solid has a finite value.
std::optional<ValueRange> rangeOf(const RenderScene& scene, std::span<const AssetModel* const> models,
                                  const Project& project, SceneColouring colouring) {
    ValueRange range{1e308, 0.0};
    forEachInstance(scene, models, [&](const AssetModel& model, Id instance, std::uint32_t) {
        const SolidQuantity quantity(project, model, instance, colouring);
        for (std::size_t solid = 0; solid < model.solids.size(); ++solid) {
            const double value = quantity.of(model, solid);
            if (std::isfinite(value)) range = {std::min(range.least, value), std::max(range.most, value)};
        }
    });
    return range.least <= range.most ? std::optional(range) : std::nullopt;
}

/// The colour of each fragment of a model by its clusters; empty without a bake.
std::vector<Colour> coloursByCluster(const AssetModel& model, const Project& project) {
    std::vector<Colour> colours;
    const Asset* asset = findAsset(project, model.asset.id);
    if (asset == nullptr || model.bake == nullptr) return colours;
    const bool hasClusters = asset->breakAs == BreakAs::Bonded && model.variant == 0;
    for (std::uint32_t fracture = 0; fracture < model.bake->fractures.size(); ++fracture) {
        const std::vector<Colour> some =
            hasClusters ? clusterColours(*asset, *model.bake, fracture)
                        : std::vector<Colour>(model.bake->fractures[fracture].fragments.count(), kUnclusteredColour);
        colours.insert(colours.end(), some.begin(), some.end());
    }
    return colours;
}

AssetFinish finishOf(const AssetModel& model, const Project& project) {
    const Material* material = materialOf(model, project);
    if (material == nullptr) return {};
    const Material* inside = insideOf(model, project);
    return assetFinish(model.asset, {*material, inside != nullptr ? *inside : *material});
}

}  // namespace

void colourBodies(RenderScene& scene, std::span<const AssetModel* const> models, const Project& project,
                  SceneColouring colouring) {
    scene.colourRange.reset();
    for (std::size_t k = 0; k < models.size(); ++k)
        scene.batches[k].finish = colouring == SceneColouring::Material ? finishOf(*models[k], project) : AssetFinish{};
    const bool isOnRamp = isQuantity(colouring) && !scene.picks.empty();
    if (isOnRamp) scene.colourRange = rangeOf(scene, models, project, colouring);
    const auto colourOf = [&](double value) {
        if (!std::isfinite(value)) return std::isnan(value) ? kWithoutValue : kNeverBreaks;
        const double spread = scene.colourRange->most - scene.colourRange->least;
        return rampColour(spread > 0.0 ? (value - scene.colourRange->least) / spread : 0.5);
    };
    std::map<const AssetModel*, std::vector<Colour>> byCluster;
    if (colouring == SceneColouring::Cluster) {
        for (const AssetModel* model : models) byCluster[model] = coloursByCluster(*model, project);
    }
    const auto ownColour = [&](const AssetModel& model, const ModelSolid& solid) {
        const auto found = byCluster.find(&model);
        const bool isKnown = found != byCluster.end() && solid.fragment < found->second.size();
        return isKnown ? found->second[solid.fragment] : byCluster.empty() ? solid.colour : kUnclusteredColour;
    };
    forEachInstance(scene, models, [&](const AssetModel& model, Id instance, std::uint32_t first) {
        const SolidQuantity quantity(project, model, instance, colouring);
        const Material* material = colouring == SceneColouring::Material ? materialOf(model, project) : nullptr;
        const Material* cutMaterial = material != nullptr ? insideOf(model, project) : nullptr;
        for (std::uint32_t solid = 0; solid < model.solids.size(); ++solid) {
            const ModelSolid& shown = model.solids[solid];
            const Colour outside = isOnRamp              ? colourOf(quantity.of(model, solid))
                                   : material != nullptr ? material->outside
                                                         : ownColour(model, shown);
            const Material* cut = cutMaterial != nullptr ? cutMaterial : material;
            scene.appearances[first + solid].outside =
                packedSurface(outside, material != nullptr ? material->opacity : 1.0);
            scene.appearances[first + solid].inside =
                cut != nullptr ? packedSurface(cut->inside, cut->opacity) : packed(insideOf(outside));
        }
    });
}

}  // namespace rubble
