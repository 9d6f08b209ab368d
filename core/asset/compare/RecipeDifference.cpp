#include "core/asset/compare/RecipeDifference.h"

#include "core/asset/compare/BondingDifference.h"
#include "core/asset/strength/Threshold.h"
#include "core/base/MessageText.h"
#include "core/base/QuantityText.h"
#include "core/fracture/layer/LayerParameter.h"
#include "core/fracture/pattern/PatternKind.h"
#include "core/fracture/pattern/SeedEdits.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr const char* kChanged = "changed";  // follows a text that does not show the difference

std::string outlineText(const Polygon& outline) {
    std::string text = countText(outline.outer.size(), "point", "points");
    if (!outline.holes.empty()) text += ", " + countText(outline.holes.size(), "hole", "holes");
    return text + ", " + roundedText(area(outline), 6) + " m²";
}

std::string textureText(const Asset& asset) { return asset.texture ? textureText(*asset.texture) : "none"; }

std::string onText(bool isOn) { return isOn ? "on" : "off"; }

std::string kindName(const PatternLayer& layer) { return std::string(kindOf(layer.parameters).name); }

std::string layerName(const PatternLayer& layer) {
    return "layer " + std::to_string(layer.id) + " (" + kindName(layer) + ")";
}

/// The data of a layer besides its parameters, as text.
std::string dataText(const LayerParameters& parameters) {
    if (const auto* placed = std::get_if<PlacedSeeds>(&parameters)) {
        return countText(placed->seeds.size(), "seed", "seeds");
    }
    if (const auto* drawn = std::get_if<CrackLines>(&parameters)) {
        return countText(drawn->lines.size(), "crack line", "crack lines");
    }
    const auto* dense = std::get_if<DensityImage>(&parameters);
    return dense && dense->image ? "a picture" : "nothing";
}

std::string parametersText(const PatternLayer& layer) {
    std::string text;
    for (const LayerParameter& parameter : kindOf(layer.parameters).parameters) {
        if (!isWritten(parameter, layer.parameters)) continue;
        text += (text.empty() ? "" : ", ") + std::string(parameter.name) + ' ' +
                parameterText(parameter, parameter.read(layer.parameters));
    }
    return text.empty() ? dataText(layer.parameters) : text;
}

std::string shapingText(const SmallPieces& small) {
    if (small.rule == SmallPieceRule::Keep) return "kept";
    const std::string rule = small.rule == SmallPieceRule::Merge ? "merged" : "without seeds";
    const std::string limit = " below " + messageText(small.limit);
    switch (small.measure) {
        case PieceMeasure::Area: return rule + limit + " m²";
        case PieceMeasure::Volume: return rule + limit + " m³";
        case PieceMeasure::FractionOfMean: return rule + limit + " of the mean";
        case PieceMeasure::FractionOfWhole: break;
    }
    return rule + limit + " of the asset";
}

std::string roughnessText(const Roughness& rough) {
    return messageText(rough.amplitude) + " m, " + messageText(rough.frequency) + " bumps per metre, " +
           countText(rough.octaves, "octave", "octaves") + ", random seed " + std::to_string(rough.randomSeed);
}

std::string thresholdText(const Project& project, const Asset& asset) {
    const std::string entered = messageText(asset.threshold) + " N·s";
    if (!asset.contactTime) return entered;
    return messageText(thresholdOf(project, asset)) + " N·s from the strength with a contact time of " +
           messageText(*asset.contactTime) + " s; entered " + entered;
}

std::string thresholdText(std::optional<double> set) { return set ? messageText(*set) + " N·s" : "by volume"; }

std::string thresholdsText(const std::vector<FragmentThreshold>& thresholds) {
    std::string text;
    for (const FragmentThreshold& own : thresholds) {
        text += (text.empty() ? "" : ", ") + own.fragment + " " + messageText(own.threshold) + " N·s";
    }
    return text.empty() ? "none" : text;
}

std::string materialText(const Project& project, Id id) {
    const Material* material = findMaterial(project, id);
    return material ? shownName(material->name) + " (" + messageText(material->density) + " kg/m³)" : "none";
}

std::string cutText(const std::optional<CutAtImpact>& cut) {
    if (!cut) return "off";
    return countText(cut->fragments, "fragment", "fragments") + ", falloff radius " + messageText(cut->falloffRadius) +
           " m";
}

bool isSameSurface(const Asset& before, const Asset& after) {
    if (!before.surface || !after.surface) return before.surface == after.surface;
    return *before.surface == *after.surface;
}

const char* scatteredInText(const PatternLayer& layer) {
    return layer.scatteredIn ? "an earlier outline" : "the outline";
}

/// Collects changes.
class Changes {
public:
    void add(const std::string& what, const std::string& before, const std::string& after) {
        if (before != after) m_list.push_back({what, before, after});
    }
    /// For values that can differ without a difference in their texts.
    void add(bool isSame, const std::string& what, const std::string& before, const std::string& after) {
        if (!isSame) m_list.push_back({what, before, after == before ? after + ", " + kChanged : after});
    }

    void compare(const PatternLayer& before, const PatternLayer& after) {
        const std::string name = layerName(after);
        add(name + ", on", onText(before.isOn), onText(after.isOn));
        add(name + ", random seed", std::to_string(before.randomSeed), std::to_string(after.randomSeed));
        add(before.overrides == after.overrides, name + ", seeds changed by hand",
            std::to_string(before.overrides.size()), std::to_string(after.overrides.size()));
        add(before.scatteredIn == after.scatteredIn, name + ", scattered in", scatteredInText(before),
            scatteredInText(after));
        if (before.parameters.index() != after.parameters.index()) {
            return add(name + ", kind", kindName(before), kindName(after));
        }
        const std::size_t countBefore = m_list.size();
        for (const LayerParameter& parameter : kindOf(after.parameters).parameters) {
            add(name + ", " + std::string(parameter.name), parameterText(parameter, parameter.read(before.parameters)),
                parameterText(parameter, parameter.read(after.parameters)));
        }
        const bool isSame = before.parameters == after.parameters || m_list.size() > countBefore;
        const std::string earlier = dataText(before.parameters), later = dataText(after.parameters);
        add(isSame && earlier == later, name + ", data", earlier, later);
    }

    void compare(const Pattern& before, const Pattern& after, const std::string& where) {
        for (const PatternLayer& layer : before.layers) {
            const PatternLayer* same = findLayer(after, layer.id);
            if (same) compare(layer, *same);
            if (!same) m_list.push_back({layerName(layer) + where, parametersText(layer), {}});
        }
        for (const PatternLayer& layer : after.layers) {
            if (!findLayer(before, layer.id)) m_list.push_back({layerName(layer) + where, {}, parametersText(layer)});
        }
        add("order of layers" + where, orderOf(before, after), orderOf(after, before));
    }

    void compare(const std::vector<Level>& before, const std::vector<Level>& after) {
        add("levels", std::to_string(before.size()), std::to_string(after.size()));
        for (std::size_t k = 0; k < std::max(before.size(), after.size()); ++k) {
            const std::string where = ", of level " + std::to_string(k + 1);
            const Level earlier = k < before.size() ? before[k] : Level(),
                        later = k < after.size() ? after[k] : Level();
            compare(earlier.pattern, later.pattern, where);
            add("minimum volume of fractured fragments" + where, messageText(earlier.minimumVolume) + " m³",
                messageText(later.minimumVolume) + " m³");
            add("threshold of fractured fragments" + where, thresholdText(earlier.threshold),
                thresholdText(later.threshold));
            add("bond strength" + where, messageText(earlier.bondStrength), messageText(later.bondStrength));
        }
    }

    void add(std::vector<RecipeChange> changes) { std::ranges::move(changes, std::back_inserter(m_list)); }

    void compare(const Shaping& before, const Shaping& after) {
        add("small fragments", shapingText(before.smallPieces), shapingText(after.smallPieces));
        add("gap", messageText(before.gap) + " m", messageText(after.gap) + " m");
        add("roughness", roughnessText(before.roughness), roughnessText(after.roughness));
    }

    std::vector<RecipeChange> list() && { return std::move(m_list); }

private:
    /// The layers of a pattern that another one also has, in order.
    static std::string orderOf(const Pattern& pattern, const Pattern& other) {
        std::string text;
        for (const PatternLayer& layer : pattern.layers) {
            if (findLayer(other, layer.id)) text += (text.empty() ? "" : ", ") + std::to_string(layer.id);
        }
        return text;
    }

    std::vector<RecipeChange> m_list;
};

}  // namespace

namespace {

std::string meshText(const ClosedMesh& mesh) {
    return std::to_string(mesh.mesh.triangles.size()) + " triangles, " +
           quantityText(QuantityKind::Volume, mesh.mass.volume);
}

void addShape(const Asset& earlier, const Asset& later, Changes& changes) {
    if (earlier.isPrism() && later.isPrism()) {
        const Prism &from = earlier.prism(), &to = later.prism();
        changes.add(from.outline == to.outline, "outline", outlineText(from.outline), outlineText(to.outline));
        changes.add("depth", messageText(from.depth) + " m", messageText(to.depth) + " m");
        return;
    }
    const auto text = [](const Asset& asset) {
        return asset.isPrism() ? std::string("a prism") : meshText(*asset.mesh());
    };
    const bool isSame = earlier.mesh() && later.mesh() && earlier.mesh()->hash == later.mesh()->hash;
    changes.add(isSame, "mesh", text(earlier), text(later));
}

}  // namespace

std::vector<RecipeChange> recipeChanges(const Project& before, const Asset& earlier, const Project& after,
                                        const Asset& later) {
    Changes changes;
    changes.add(earlier.name == later.name, "name", shownName(earlier.name), shownName(later.name));
    addShape(earlier, later, changes);
    changes.add("material", materialText(before, earlier.material), materialText(after, later.material));
    changes.add("inside material", materialText(before, earlier.insideMaterial),
                materialText(after, later.insideMaterial));
    changes.add("threshold", thresholdText(before, earlier), thresholdText(after, later));
    changes.add("inside UV scale", messageText(earlier.insideUvScale), messageText(later.insideUvScale));
    changes.add("cut at impact", cutText(earlier.cutAtImpact), cutText(later.cutAtImpact));
    changes.add(bondingChanges(earlier, later));
    changes.compare(earlier.pattern, later.pattern, "");
    changes.compare(earlier.levels, later.levels);
    changes.compare(earlier.shaping, later.shaping);
    changes.add(earlier.fragmentLevels == later.fragmentLevels, "fragments with their own pattern",
                std::to_string(earlier.fragmentLevels.size()), std::to_string(later.fragmentLevels.size()));
    changes.add("thresholds of single fragments", thresholdsText(earlier.fragmentThresholds),
                thresholdsText(later.fragmentThresholds));
    changes.add(earlier.edits == later.edits, "fragments merged or split", std::to_string(earlier.edits.size()),
                std::to_string(later.edits.size()));
    changes.add(earlier.requirements == later.requirements, "strength requirements",
                std::to_string(earlier.requirements.size()), std::to_string(later.requirements.size()));
    changes.add(isSameSurface(earlier, later), "surface of the imported mesh", onText(earlier.surface != nullptr),
                onText(later.surface != nullptr));
    changes.add(earlier.texture == later.texture, "base-colour texture", textureText(earlier), textureText(later));
    return std::move(changes).list();
}

std::string sentenceOf(const RecipeChange& change) {
    if (change.before.empty()) return change.what + " added: " + change.after;
    if (change.after.empty()) return change.what + " removed: " + change.before;
    return change.what + ": " + change.after + ", was " + change.before;
}

}  // namespace rubble
