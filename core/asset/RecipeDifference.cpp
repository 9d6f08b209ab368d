#include "core/asset/RecipeDifference.h"

#include "core/asset/Threshold.h"
#include "core/base/MessageText.h"
#include "core/fracture/ParameterText.h"
#include "core/fracture/PatternKind.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr const char* kOtherwise = "otherwise";  // behind something that words cannot tell apart

std::string countText(std::size_t count, const char* one, const char* many) {
    return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

std::string outlineText(const Polygon& outline) {
    std::string text = countText(outline.outer.size(), "point", "points");
    if (!outline.holes.empty()) text += ", " + countText(outline.holes.size(), "hole", "holes");
    return text + ", " + roundedText(area(outline), 6) + " m^2";
}

std::string onText(bool isOn) { return isOn ? "on" : "off"; }

std::string kindName(const PatternLayer& layer) { return std::string(kindOf(layer.parameters).name); }

std::string layerName(const PatternLayer& layer) {
    return "layer " + std::to_string(layer.id) + " (" + kindName(layer) + ")";
}

/// What a layer holds beside its parameters, in words.
std::string heldText(const LayerParameters& parameters) {
    if (const auto* placed = std::get_if<PlacedSeeds>(&parameters)) {
        return countText(placed->seeds.size(), "seed", "seeds");
    }
    if (const auto* drawn = std::get_if<Strokes>(&parameters)) {
        return countText(drawn->strokes.size(), "stroke", "strokes");
    }
    const auto* dense = std::get_if<DensityImage>(&parameters);
    return dense && dense->image ? "a picture" : "nothing";
}

std::string parametersText(const PatternLayer& layer) {
    std::string text;
    for (const LayerParameter& parameter : kindOf(layer.parameters).parameters) {
        text +=
            (text.empty() ? "" : ", ") + std::string(parameter.name) + ' ' + parameterText(parameter, layer.parameters);
    }
    return text.empty() ? heldText(layer.parameters) : text;
}

std::string shapingText(const SmallPieces& small) {
    if (small.rule == SmallPieceRule::Keep) return "kept";
    const std::string rule = small.rule == SmallPieceRule::Merge ? "merged" : "without seeds";
    const std::string limit = " below " + messageText(small.limit);
    switch (small.measure) {
        case PieceMeasure::Area: return rule + limit + " m^2";
        case PieceMeasure::Volume: return rule + limit + " m^3";
        case PieceMeasure::PartOfMean: return rule + limit + " of the mean";
        case PieceMeasure::PartOfWhole: break;
    }
    return rule + limit + " of the whole";
}

std::string roughnessText(const Roughness& rough) {
    return messageText(rough.amplitude) + " m, " + messageText(rough.frequency) + " bumps a metre, " +
           countText(rough.octaves, "octave", "octaves") + ", random seed " + std::to_string(rough.randomSeed);
}

std::string thresholdText(const Project& project, const Asset& asset) {
    const std::string typed = messageText(asset.threshold) + " N s";
    if (!asset.contactTime) return typed;
    return messageText(thresholdOf(project, asset)) + " N s from strength, by a contact of " +
           messageText(*asset.contactTime) + " s; typed " + typed;
}

std::string materialText(const Project& project, Id id) {
    const Material* material = findMaterial(project, id);
    return material ? material->name + " (" + messageText(material->density) + " kg/m^3)" : "none";
}

std::string cutText(const std::optional<CutAtImpact>& cut) {
    if (!cut) return "off";
    return countText(cut->pieces, "piece", "pieces") + ", reach " + messageText(cut->reach) + " m";
}

const PatternLayer* findLayer(const Pattern& pattern, std::uint32_t id) {
    const auto found = std::ranges::find(pattern.layers, id, &PatternLayer::id);
    return found != pattern.layers.end() ? &*found : nullptr;
}

/// Collects what differs.
class Changes {
public:
    void note(const std::string& what, const std::string& before, const std::string& after) {
        if (before != after) m_list.push_back({what, before, after});
    }
    /// The same for what may differ in more than its text says.
    void note(bool isSame, const std::string& what, const std::string& before, const std::string& after) {
        if (!isSame) m_list.push_back({what, before, after == before ? after + ", " + kOtherwise : after});
    }

    void compare(const PatternLayer& before, const PatternLayer& after) {
        const std::string name = layerName(after);
        note(name + ", on", onText(before.isOn), onText(after.isOn));
        note(name + ", random seed", std::to_string(before.randomSeed), std::to_string(after.randomSeed));
        note(before.overrides == after.overrides, name + ", seeds changed by hand",
             std::to_string(before.overrides.size()), std::to_string(after.overrides.size()));
        if (before.parameters.index() != after.parameters.index()) {
            return note(name + ", kind", kindName(before), kindName(after));
        }
        const std::size_t known = m_list.size();
        for (const LayerParameter& parameter : kindOf(after.parameters).parameters) {
            note(name + ", " + std::string(parameter.name), parameterText(parameter, before.parameters),
                 parameterText(parameter, after.parameters));
        }
        const bool isSame = before.parameters == after.parameters || m_list.size() > known;
        const std::string earlier = heldText(before.parameters), later = heldText(after.parameters);
        note(isSame && earlier == later, name + ", holds", earlier, later);
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
        note("order of layers" + where, orderOf(before, after), orderOf(after, before));
    }

    void compare(const std::vector<Level>& before, const std::vector<Level>& after) {
        note("levels", std::to_string(before.size()), std::to_string(after.size()));
        for (std::size_t k = 0; k < std::max(before.size(), after.size()); ++k) {
            const std::string where = ", of level " + std::to_string(k + 1);
            const Level earlier = k < before.size() ? before[k] : Level(),
                        later = k < after.size() ? after[k] : Level();
            compare(earlier.pattern, later.pattern, where);
            note("smallest piece that is broken" + where, messageText(earlier.minimumVolume) + " m^3",
                 messageText(later.minimumVolume) + " m^3");
        }
    }

    void compare(const Shaping& before, const Shaping& after) {
        note("small pieces", shapingText(before.smallPieces), shapingText(after.smallPieces));
        note("gap", messageText(before.gap) + " m", messageText(after.gap) + " m");
        note("roughness", roughnessText(before.roughness), roughnessText(after.roughness));
    }

    std::vector<RecipeChange> list() && { return std::move(m_list); }

private:
    /// The layers of a pattern that another one has, too, in order.
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

std::vector<RecipeChange> recipeChanges(const Project& before, const Asset& earlier, const Project& after,
                                        const Asset& later) {
    Changes changes;
    changes.note("name", earlier.name, later.name);
    const Prism &from = earlier.prism, &to = later.prism;
    changes.note(from.outline == to.outline, "outline", outlineText(from.outline), outlineText(to.outline));
    changes.note("depth", messageText(from.depth) + " m", messageText(to.depth) + " m");
    changes.note("material", materialText(before, earlier.material), materialText(after, later.material));
    changes.note("inside material", materialText(before, earlier.insideMaterial),
                 materialText(after, later.insideMaterial));
    changes.note("threshold", thresholdText(before, earlier), thresholdText(after, later));
    changes.note("inside UV scale", messageText(earlier.insideUvScale), messageText(later.insideUvScale));
    changes.note("cut at impact", cutText(earlier.cutAtImpact), cutText(later.cutAtImpact));
    changes.compare(earlier.pattern, later.pattern, "");
    changes.compare(earlier.levels, later.levels);
    changes.compare(earlier.shaping, later.shaping);
    changes.note(earlier.leaves == later.leaves, "fragments broken in their own way",
                 std::to_string(earlier.leaves.size()), std::to_string(later.leaves.size()));
    changes.note(earlier.edits == later.edits, "fragments merged or split", std::to_string(earlier.edits.size()),
                 std::to_string(later.edits.size()));
    changes.note(earlier.intents == later.intents, "intents", std::to_string(earlier.intents.size()),
                 std::to_string(later.intents.size()));
    return std::move(changes).list();
}

std::string sentenceOf(const RecipeChange& change) {
    if (change.before.empty()) return change.what + " is new: " + change.after;
    if (change.after.empty()) return change.what + " is gone: " + change.before;
    return change.what + ": " + change.after + ", was " + change.before;
}

}  // namespace rubble
