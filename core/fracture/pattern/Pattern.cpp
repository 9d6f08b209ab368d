#include "core/fracture/pattern/Pattern.h"

#include "core/base/MessageText.h"
#include "core/fracture/pattern/PatternKind.h"

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
        if (!change.isDeleted && !(std::isfinite(change.position.x) && std::isfinite(change.position.y))) {
            return seed + " moves it to (" + messageText(change.position.x) + ", " + messageText(change.position.y) +
                   "), which is not finite";
        }
    }
    return std::nullopt;
}

/// Moves and deletes seeds of the last layer, which start at `first`, ascending by index.
void applyOverrides(const LayerContext& context, std::size_t first, SeedSet& seeds) {
    if (context.layer.overrides.empty()) return;
    std::vector<bool> isDeleted(seeds.size() - first, false);
    const auto begin = seeds.ids.begin() + static_cast<std::ptrdiff_t>(first);
    for (const SeedOverride& change : context.layer.overrides) {
        const auto found = std::ranges::lower_bound(begin, seeds.ids.end(), change.index, {}, &SeedId::index);
        if (found == seeds.ids.end() || found->index != change.index) {
            seeds.diagnostics.push_back(diagnostic(DiagnosticCode::LostOverride,
                                                   {.layer = context.layer.id, .index = change.index},
                                                   context.name() + " has no seed " + std::to_string(change.index) +
                                                       " any more; its manual change is ignored."));
            continue;
        }
        const std::size_t seed = static_cast<std::size_t>(found - seeds.ids.begin());
        seeds.positions[seed] = change.isDeleted ? seeds.positions[seed] : change.position;
        seeds.isLocked[seed] = true;
        isDeleted[seed - first] = change.isDeleted;
    }
    std::size_t kept = first;
    for (std::size_t seed = first; seed < seeds.size(); ++seed) {
        if (isDeleted[seed - first]) continue;
        seeds.positions[kept] = seeds.positions[seed];
        seeds.ids[kept] = seeds.ids[seed];
        seeds.isLocked[kept] = seeds.isLocked[seed];
        ++kept;
    }
    seeds.positions.resize(kept);
    seeds.ids.resize(kept);
    seeds.isLocked.resize(kept);
}

template <class Parameters>
std::optional<std::string> parametersFault(const Parameters& parameters) {
    for (const LayerParameter& parameter : Parameters::kKind.parameters) {
        if (std::optional<std::string> fault = parameterFault(parameter, parameters)) return fault;
    }
    if constexpr (requires { parameters.fault(); }) {
        return parameters.fault();
    } else {
        return std::nullopt;
    }
}

/// The kinds of the alternatives of a variant.
template <class... Parameters>
constexpr auto kindsOf(const std::variant<Parameters...>*) {
    return std::array{&Parameters::kKind...};
}
constexpr auto kKinds = kindsOf(static_cast<const LayerParameters*>(nullptr));

}  // namespace

const PatternKind& kindOf(const LayerParameters& parameters) { return *kKinds[parameters.index()]; }

std::span<const PatternKind* const> patternKinds() { return kKinds; }

void SeedSet::add(SeedId id, Vec2 position, bool locked) {
    positions.push_back(position);
    ids.push_back(id);
    isLocked.push_back(locked);
}

void SeedSet::reserve(std::size_t additional) {
    positions.reserve(size() + additional);
    ids.reserve(size() + additional);
    isLocked.reserve(size() + additional);
}

std::string LayerContext::name() const { return "Layer " + std::to_string(layer.id); }

Error tooManySeeds(const LayerContext& context) {
    return {ErrorCode::Limit, context.name() + " brings the pattern above " + std::to_string(kMaxSeeds) + " seeds."};
}

Result<std::uint32_t> seedsToAdd(const SeedCount& count, const Polygon& domain, const LayerContext& context,
                                 const SeedSet& seeds) {
    const double wanted = count.in(area(domain));
    if (!(wanted <= static_cast<double>(kMaxSeeds - seeds.size()))) return tooManySeeds(context);
    return static_cast<std::uint32_t>(wanted);
}

std::string SeedId::text() const { return std::to_string(layer) + "." + std::to_string(index); }

std::optional<SeedId> seedOf(const DiagnosticPlace& place) {
    if (place.index == kNone) return std::nullopt;
    return SeedId{place.layer, place.index};
}

std::optional<std::string> verifyPattern(const Pattern& pattern) {
    for (const PatternLayer& layer : pattern.layers) {
        std::optional<std::string> fault =
            std::visit([](const auto& parameters) { return parametersFault(parameters); }, layer.parameters);
        if (!fault) fault = overrideFault(layer.overrides);
        if (fault) return "Layer " + std::to_string(layer.id) + ": " + *fault + ".";
    }
    return std::nullopt;
}

Result<Seeds> seedsOf(const Pattern& pattern, const Polygon& outline, const TaskContext& task) {
    if (std::optional<std::string> fault = verifyPattern(pattern)) return Error{ErrorCode::BadInput, *fault};
    SeedSet seeds;
    for (const PatternLayer& layer : pattern.layers) {
        if (!layer.isOn) continue;
        if (task.isCancelled()) return TaskContext::cancelled();
        const std::span before(pattern.layers.data(), &layer);
        const LayerContext context{layer, outline, task, before, &pattern};
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
    return Seeds{std::move(seeds.positions), std::move(seeds.ids), std::move(seeds.diagnostics)};
}

}  // namespace rubble
