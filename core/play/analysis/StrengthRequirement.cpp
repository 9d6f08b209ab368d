#include "core/play/analysis/StrengthRequirement.h"

#include "core/asset/bake/FractureResult.h"
#include "core/asset/strength/BondStrength.h"
#include "core/base/Assert.h"
#include "core/base/MessageText.h"
#include "core/play/analysis/RequirementImpulse.h"
#include "core/play/scene/PlayStructure.h"
#include "core/structure/rule/SimpleRule.h"

#include <cmath>

namespace rubble {
namespace {

constexpr double kMargin = 1.25;  // of a suggested threshold beyond the only bound

/// Four significant digits, or all before the decimal point, without an exponent.
std::string figureText(double value) { return value < 1e4 ? roundedText(value, 4) : messageText(std::round(value)); }

void restrict(ThresholdInterval& interval, RequirementOutcome outcome, std::uint32_t requirement) {
    const double impulse = interval.impulses[requirement];
    if (outcome == RequirementOutcome::Survives && impulse > interval.low) {
        interval.low = impulse;
        interval.lowRequirement = requirement;
    }
    if (outcome == RequirementOutcome::Breaks && impulse < interval.high) {
        interval.high = impulse;
        interval.highRequirement = requirement;
    }
}

std::string eventText(RequirementOutcome outcome, const DropRequirement& drop) {
    return (outcome == RequirementOutcome::Survives ? "survives a drop of " : "breaks in a drop of ") +
           messageText(drop.height) + " m";
}

std::string eventText(RequirementOutcome outcome, const HitRequirement& hit) {
    return (outcome == RequirementOutcome::Survives ? "survives being hit by " : "breaks when hit by ") +
           messageText(hit.mass) + " kg at " + messageText(hit.speed) + " m/s";
}

std::string eventText(RequirementOutcome outcome, const ImpulseRequirement& impact) {
    return (outcome == RequirementOutcome::Survives ? "survives an impulse of " : "breaks at an impulse of ") +
           impulseText(impact.impulse);
}

}  // namespace

bool hasThreshold(const Project& project, const Asset& asset) {
    return asset.breakAs == BreakAs::Whole || project.damage.isThesis;
}

std::optional<double> ThresholdInterval::suggested() const {
    if (isEmpty() || (lowRequirement == kNone && highRequirement == kNone)) return std::nullopt;
    if (lowRequirement == kNone) return high / kMargin;
    if (highRequirement == kNone) return low * kMargin;
    return std::sqrt(low) * std::sqrt(high);
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
        interval.impulses.push_back(*impulse);
        restrict(interval, requirement.outcome, static_cast<std::uint32_t>(interval.impulses.size() - 1));
    }
    return interval;
}

Result<ThresholdInterval> bondInterval(const Project& project, std::shared_ptr<const PlayAsset> asset) {
    const Asset& authored = *findAsset(project, asset->bake->asset);
    const Material& material = *findMaterial(project, authored.material);
    ThresholdInterval interval{.isPerArea = true};
    const std::shared_ptr<const PlayStructure> bonds =
        asset->fractureOf(kNone) != nullptr ? playStructure(authored, material, asset, kNone) : nullptr;
    for (const StrengthRequirement& requirement : authored.requirements) {
        const Result<RequirementImpact> impact = requirementImpact(project, *asset, requirement);
        if (!impact) return ofAsset(authored, impact.error());
        double utilization = 0.0;
        if (bonds != nullptr && !impact->points.empty()) {
            std::vector<BondDamage> damage(bonds->initialDamage);
            const std::vector<std::uint32_t> owners(bonds->nodeCount(), 0);
            utilization = applyHit(bonds->graph, bonds->capacities, bonds->rule,
                                   {.points = impact->points, .impulse = impact->impulse}, owners, 0, damage)
                              .utilization;
        }
        interval.impulses.push_back(bondImpulseOf(authored, material) * utilization);
        restrict(interval, requirement.outcome, static_cast<std::uint32_t>(interval.impulses.size() - 1));
    }
    return interval;
}

StrengthRequirement impulseRequirement(RequirementOutcome outcome, double impulse) {
    const double unit = std::pow(10.0, std::floor(std::log10(impulse)) - 2.0);
    const double digits = impulse / unit;
    return {outcome, ImpulseRequirement{
                         unit * (outcome == RequirementOutcome::Breaks ? std::floor(digits) : std::ceil(digits))}};
}

std::string requirementText(const StrengthRequirement& requirement) {
    return std::visit([&](const auto& event) { return eventText(requirement.outcome, event); }, requirement.event);
}

std::optional<std::string> conflictText(const Asset& asset, const ThresholdInterval& interval) {
    if (!interval.isEmpty()) return std::nullopt;
    const std::string breaks = '"' + requirementText(asset.requirements[interval.highRequirement]) + '"';
    if (interval.high == 0.0) return breaks + " cannot be met: such a slow contact does no damage.";
    const std::string survives = '"' + requirementText(asset.requirements[interval.lowRequirement]) + '"';
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
    return figureText(impulse) + (isPerArea ? " N·s/m²" : " N·s");
}

}  // namespace rubble
