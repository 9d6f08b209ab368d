#include "core/fracture/pattern/Pattern.h"

#include "core/base/MessageText.h"
#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/layer/LayerKind.h"
#include "core/fracture/pattern/PatternKind.h"
#include "core/fracture/pattern/PatternPartition.h"
#include "core/fracture/pattern/SolidPatternCut.h"
#include "core/geometry/polygon/PolygonFaults.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

std::optional<std::string> overrideFault(const std::vector<SeedOverride>& overrides) {
    for (std::size_t k = 0; k < overrides.size(); ++k) {
        const SeedOverride& change = overrides[k];
        const std::string seed = "the change to seed " + std::to_string(change.index);
        if (k > 0 && change.index <= overrides[k - 1].index) {
            return seed + " does not come after the one to seed " + std::to_string(overrides[k - 1].index);
        }
        if (!change.isDeleted && !std::isfinite(change.height)) {
            return seed + " moves it to a height of " + messageText(change.height) + ", which is not finite";
        }
        if (!change.isDeleted && !(std::isfinite(change.position.x) && std::isfinite(change.position.y))) {
            return seed + " moves it to (" + messageText(change.position.x) + ", " + messageText(change.position.y) +
                   "), which is not finite";
        }
    }
    return std::nullopt;
}

std::optional<std::string> scatteredInFault(const Polygon& outline) {
    const Result<Polygon> valid = validated(outline);
    if (!valid)
        return "the outline in which its seeds were scattered is not valid: " +
               valid.error().message.substr(0, valid.error().message.size() - 1);
    if (*valid != outline) return "the outline in which its seeds were scattered is clockwise, or a hole of it is not";
    return std::nullopt;
}

/// Moves and deletes seeds of the last layer, which start at `first`, ascending by index.
void applyOverrides(const EvaluatedLayer& context, std::size_t first, SeedSet& seeds) {
    if (context.overrides.empty()) return;
    std::vector<bool> isDeleted(seeds.size() - first, false);
    const auto begin = seeds.ids.begin() + static_cast<std::ptrdiff_t>(first);
    for (const SeedOverride& change : context.overrides) {
        const auto found = std::ranges::lower_bound(begin, seeds.ids.end(), change.index, {}, &SeedId::index);
        if (found == seeds.ids.end() || found->index != change.index) {
            seeds.diagnostics.push_back(diagnostic(DiagnosticCode::LostOverride,
                                                   {.layer = context.layerId, .index = change.index},
                                                   context.name() + " has no seed " + std::to_string(change.index) +
                                                       " any more; its manual change is ignored."));
            continue;
        }
        const std::size_t seed = static_cast<std::size_t>(found - seeds.ids.begin());
        if (!change.isDeleted) seeds.positions[seed] = change.position;
        if (!change.isDeleted && !seeds.heights.empty()) seeds.heights[seed] = change.height;
        seeds.isLocked[seed] = true;
        isDeleted[seed - first] = change.isDeleted;
    }
    seeds.remove(first, isDeleted);
}

template <class Parameters>
std::optional<std::string> parametersFault(const Parameters& parameters) {
    for (const LayerParameter& parameter : Parameters::kKind.parameters) {
        if (std::optional<std::string> fault = parameterFault(parameter, parameter.readFrom(&parameters))) return fault;
    }
    if constexpr (requires { parameters.fault(); }) {
        return parameters.fault();
    } else {
        return std::nullopt;
    }
}

Diagnostic needsPlane(const PatternLayer& layer) {
    return diagnostic(DiagnosticCode::NeedsPlane, {.layer = layer.id},
                      "Layer " + std::to_string(layer.id) + " (" + kindOf(layer.parameters).caption +
                          ") needs a plane and has no effect on a mesh.");
}

/// The densities of enabled layers. Those of later kinds come first: their sum depends on the order in its last bits.
std::vector<SeedDensity> densitiesOf(std::span<const PatternLayer> layers, const Polygon& outline) {
    std::vector<SeedDensity> densities;
    for (std::size_t kind = std::variant_size_v<LayerParameters>; kind-- > 0;) {
        for (const PatternLayer& layer : layers) {
            if (!layer.isOn || layer.parameters.index() != kind) continue;
            SeedDensity density = std::visit(
                [&](const auto& parameters) -> SeedDensity {
                    if constexpr (requires { parameters.density(outline); })
                        return parameters.density(layer.scatteredIn.value_or(outline));
                    return nullptr;
                },
                layer.parameters);
            if (density) densities.push_back(std::move(density));
        }
    }
    return densities;
}

}  // namespace

std::optional<std::string> verifyPattern(const Pattern& pattern) {
    for (const PatternLayer& layer : pattern.layers) {
        std::optional<std::string> fault =
            std::visit([](const auto& parameters) { return parametersFault(parameters); }, layer.parameters);
        if (!fault) fault = overrideFault(layer.overrides);
        if (!fault && layer.scatteredIn) fault = scatteredInFault(*layer.scatteredIn);
        if (fault) return "Layer " + std::to_string(layer.id) + ": " + *fault + ".";
    }
    return std::nullopt;
}

Result<Seeds> seedsOf(const Pattern& pattern, const Polygon& outline, const TaskContext& task) {
    if (std::optional<std::string> fault = verifyPattern(pattern)) return Error{ErrorCode::BadInput, *fault};
    const auto cells = [&](std::span<const Vec2> positions) -> Result<Partition> {
        Result<TriangulatedPartition> found = cellsOf(pattern, positions, outline, task);
        if (!found) return found.error();
        return std::move(found->partition);
    };
    SeedSet seeds;
    for (const PatternLayer& layer : pattern.layers) {
        if (!layer.isOn) continue;
        if (task.isCancelled()) return TaskContext::cancelled();
        const LayerContext context{{layer.id, layer.randomSeed, layer.overrides, task},
                                   outline,
                                   cells,
                                   densitiesOf(std::span(pattern.layers.data(), &layer), outline),
                                   layer.scatteredIn ? &*layer.scatteredIn : nullptr};
        const std::size_t first = seeds.size();
        const Status applied = std::visit(
            [&](const auto& parameters) -> Status {
                if constexpr (requires { parameters.apply(context, seeds); }) return parameters.apply(context, seeds);
                return success();
            },
            layer.parameters);
        if (!applied) return applied.error();
        applyOverrides(context, first, seeds);
    }
    return Seeds{std::move(seeds.positions), {}, std::move(seeds.ids), std::move(seeds.diagnostics)};
}

Result<Seeds> seedsOf(const Pattern& pattern, const SolidDomain& domain, const TaskContext& task) {
    if (std::optional<std::string> fault = verifyPattern(pattern)) return Error{ErrorCode::BadInput, *fault};
    const auto cells = [&](std::span<const Vec3> positions) {
        return cutWithPattern(pattern, domain.mesh(), positions, task);
    };
    SeedSet seeds;
    for (const PatternLayer& layer : pattern.layers) {
        if (!layer.isOn) continue;
        if (task.isCancelled()) return TaskContext::cancelled();
        const SolidLayerContext context{{layer.id, layer.randomSeed, layer.overrides, task}, domain, cells};
        if (!kindOf(layer.parameters).isSpatial) {
            seeds.diagnostics.push_back(needsPlane(layer));
            continue;
        }
        const std::size_t first = seeds.size();
        const Status applied = std::visit(
            [&](const auto& parameters) -> Status {
                if constexpr (requires { parameters.applyInSolid(context, seeds); })
                    return parameters.applyInSolid(context, seeds);
                return success();
            },
            layer.parameters);
        if (!applied) return applied.error();
        applyOverrides(context, first, seeds);
    }
    return Seeds{std::move(seeds.positions), std::move(seeds.heights), std::move(seeds.ids),
                 std::move(seeds.diagnostics)};
}

}  // namespace rubble
