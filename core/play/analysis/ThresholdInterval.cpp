#include "core/play/analysis/ThresholdInterval.h"

#include "core/asset/bake/FractureResult.h"
#include "core/asset/project/AssetShape.h"
#include "core/asset/project/Ranges.h"
#include "core/asset/strength/BondStrength.h"
#include "core/base/Assert.h"
#include "core/base/MessageText.h"
#include "core/geometry/hull/Diameter.h"
#include "core/play/analysis/HitForecast.h"
#include "core/play/analysis/RequirementImpulse.h"
#include "core/play/scene/PlayStructure.h"

#include <cmath>

namespace rubble {
namespace {

constexpr double kMargin = 1.25;  // of a suggested threshold beyond the only bound

/// Four significant digits, or all before the decimal point, without an exponent.
std::string figureText(double value) { return value < 1e4 ? roundedText(value, 4) : messageText(std::round(value)); }

void restrict(ThresholdInterval& interval, RequirementOutcome outcome, std::uint32_t requirement) {
    const double impulse = interval.impulses[requirement];
    if (outcome != RequirementOutcome::Breaks && impulse > interval.low) {
        interval.low = impulse;
        interval.lowRequirement = requirement;
    }
    if (outcome == RequirementOutcome::Breaks && impulse < interval.high) {
        interval.high = impulse;
        interval.highRequirement = requirement;
    }
}

/// The outcome of a requirement as text, with a space behind it: for events "survives a drop", or with the words for
/// one that happens to it, "survives being hit".
std::string outcomeText(const StrengthRequirement& requirement, const char* survives, const char* breaks) {
    switch (requirement.outcome) {
        case RequirementOutcome::Survives: return survives;
        case RequirementOutcome::Breaks: return breaks;
        case RequirementOutcome::HoleAtMost: break;
    }
    const std::string_view event = breaks;
    return "gets a hole of at most " + roundedText(requirement.hole, 4) + " m" +
           std::string(event.substr(event.find(' ')));
}

std::string eventText(const StrengthRequirement& requirement, const DropRequirement& drop) {
    return outcomeText(requirement, "survives a drop of ", "breaks in a drop of ") + messageText(drop.height) + " m";
}

std::string eventText(const StrengthRequirement& requirement, const HitRequirement& hit) {
    return outcomeText(requirement, "survives being hit by ", "breaks when hit by ") + messageText(hit.mass) +
           " kg at " + messageText(hit.speed) + " m/s";
}

std::string eventText(const StrengthRequirement& requirement, const ImpulseRequirement& impact) {
    return outcomeText(requirement, "survives an impulse of ", "breaks at an impulse of ") +
           impulseText(impact.impulse);
}

/// The forecast of the event of a requirement for the structure of an asset.
Result<HitForecast> forecastOf(const Project& project, const PlayAsset& asset,
                               std::shared_ptr<const PlayStructure> structure, const StrengthRequirement& requirement) {
    Result<RequirementImpact> impact = requirementImpact(project, asset, requirement);
    if (!impact) return ofAsset(*findAsset(project, asset.bake->asset), impact.error());
    return HitForecast(std::move(structure), std::move(*impact));
}

/// The structure of an asset; null if it does not break.
std::shared_ptr<const PlayStructure> structureOf(const Project& project,
                                                 const std::shared_ptr<const PlayAsset>& asset) {
    const Asset& authored = *findAsset(project, asset->bake->asset);
    if (asset->fractureOf(kNone) == nullptr) return nullptr;
    return playStructure(authored, *findMaterial(project, authored.material), asset, kNone);
}

/// The width of the hole that all of an asset leaves, m.
double widthOf(const Asset& asset) {
    return asset.isPrism() ? diameterOf(asset.prism().outline.outer) : planeBoundsOf(asset).diagonal();
}

/// Whether an asset that breaks whole leaves a hole that a requirement allows.
bool allowsBreaking(const Asset& asset, const StrengthRequirement& requirement) {
    return requirement.outcome == RequirementOutcome::HoleAtMost && widthOf(asset) <= requirement.hole;
}

}  // namespace

bool hasThreshold(const Project& project, const Asset& asset) {
    return asset.breakAs == BreakAs::Whole || project.damage.isThesis;
}

std::optional<double> ThresholdInterval::suggested() const {
    if (isEmpty() || (lowRequirement == kNone && highRequirement == kNone)) return std::nullopt;
    if (lowRequirement == kNone) return high / kMargin;
    const double margin = highRequirement == kNone ? low * kMargin : std::sqrt(low) * std::sqrt(high);
    if (!rangeOf(isPerArea ? ProjectNumber::BondImpulse : ProjectNumber::Threshold).contains(margin))
        return std::nullopt;
    return margin;
}

Result<ThresholdInterval> thresholdInterval(const Project& project, const PlayAsset& asset) {
    const Asset* authored = findAsset(project, asset.bake->asset);
    RUBBLE_ASSERT(authored != nullptr);
    if (!hasThreshold(project, *authored)) {
        return ofAsset(*authored, {ErrorCode::BadInput,
                                   "This asset breaks along bonds: its requirements bound the impulse per area, not a "
                                   "threshold."});
    }
    ThresholdInterval interval;
    for (const StrengthRequirement& requirement : authored->requirements) {
        const Result<double> impulse = requirementImpulse(project, asset, requirement);
        if (!impulse) return ofAsset(*authored, impulse.error());
        interval.impulses.push_back(allowsBreaking(*authored, requirement) ? 0.0 : *impulse);
        restrict(interval, requirement.outcome, static_cast<std::uint32_t>(interval.impulses.size() - 1));
    }
    return interval;
}

Result<ThresholdInterval> bondInterval(const Project& project, std::shared_ptr<const PlayAsset> asset) {
    const Asset& authored = *findAsset(project, asset->bake->asset);
    const double impulsePerArea = bondImpulseOf(authored, *findMaterial(project, authored.material));
    ThresholdInterval interval{.isPerArea = true};
    const std::shared_ptr<const PlayStructure> structure = structureOf(project, asset);
    for (const StrengthRequirement& requirement : authored.requirements) {
        double strength = 0.0;
        if (structure != nullptr) {
            const Result<HitForecast> forecast = forecastOf(project, *asset, structure, requirement);
            if (!forecast) return forecast.error();
            strength = requirement.outcome == RequirementOutcome::HoleAtMost ? forecast->strengthFor(requirement.hole)
                                                                             : forecast->breaking();
        }
        interval.impulses.push_back(impulsePerArea * strength);
        restrict(interval, requirement.outcome, static_cast<std::uint32_t>(interval.impulses.size() - 1));
    }
    return interval;
}

Result<std::vector<std::uint32_t>> fragmentsLost(const Project& project, std::shared_ptr<const PlayAsset> asset,
                                                 const StrengthRequirement& requirement) {
    const std::shared_ptr<const PlayStructure> structure = structureOf(project, asset);
    if (structure == nullptr) return std::vector<std::uint32_t>();
    const Result<HitForecast> forecast = forecastOf(project, *asset, structure, requirement);
    if (!forecast) return forecast.error();
    std::vector<std::uint32_t> fragments;
    for (const std::uint32_t node : forecast->lost(1.0)) fragments.push_back(structure->fragmentOf(node));
    return fragments;
}

StrengthRequirement impulseRequirement(RequirementOutcome outcome, double impulse) {
    const double unit = std::pow(10.0, std::floor(std::log10(impulse)) - 2.0);
    const double digits = impulse / unit;
    return {outcome, ImpulseRequirement{
                         unit * (outcome == RequirementOutcome::Breaks ? std::floor(digits) : std::ceil(digits))}};
}

std::string requirementText(const StrengthRequirement& requirement) {
    return std::visit([&](const auto& event) { return eventText(requirement, event); }, requirement.event);
}

std::optional<std::string> conflictText(const Asset& asset, const ThresholdInterval& interval) {
    if (!interval.isEmpty()) return std::nullopt;
    const auto quoted = [&](std::uint32_t requirement) {
        return requirement == kNone ? "" : '"' + requirementText(asset.requirements[requirement]) + '"';
    };
    const std::string breaks = quoted(interval.highRequirement);
    if (interval.highRequirement != kNone && interval.high == 0.0)
        return breaks + " cannot be met: " +
               (interval.isPerArea ? "no bond breaks in this event." : "such a slow contact does no damage.");
    const std::string survives = quoted(interval.lowRequirement);
    if (std::isinf(interval.low)) return survives + " cannot be met: as much is loose before anything is hit.";
    const double apart = interval.low - interval.high;
    const auto text = [&](double impulse) { return impulseText(impulse, interval.isPerArea); };
    return survives + " needs " + (interval.isPerArea ? "an impulse per area above " : "a threshold above ") +
           text(interval.low) + ", " + breaks + " one of at most " + text(interval.high) + ": they are " + text(apart) +
           " (" + figureText(100.0 * apart / interval.high) + " %) apart.";
}

std::string intervalText(const ThresholdInterval& interval) {
    const std::string low = "above " + impulseText(interval.low, interval.isPerArea);
    if (interval.highRequirement == kNone) return interval.lowRequirement == kNone ? "any" : low;
    const std::string high = "at most " + impulseText(interval.high, interval.isPerArea);
    return interval.lowRequirement == kNone ? high : low + " and " + high;
}

std::string impulseText(double impulse, bool isPerArea) {
    if (std::isinf(impulse)) return "none";
    return figureText(impulse) + (isPerArea ? " N·s/m²" : " N·s");
}

}  // namespace rubble
