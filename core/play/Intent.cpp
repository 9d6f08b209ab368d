#include "core/play/Intent.h"

#include "core/asset/Breaking.h"
#include "core/base/Assert.h"
#include "core/base/MessageText.h"
#include "core/play/IntentImpulse.h"

#include <cmath>

namespace rubble {
namespace {

constexpr double kRoom = 1.25;  // beyond the only bound, for a threshold to suggest

/// Four digits, or all those before the point, without an exponent.
std::string figureText(double value) { return value < 1e4 ? roundedText(value, 4) : messageText(std::round(value)); }

void narrow(ThresholdInterval& interval, IntentOutcome outcome, std::uint32_t intent) {
    const double impulse = interval.impulses[intent];
    if (outcome == IntentOutcome::Survives && impulse > interval.low) {
        interval.low = impulse;
        interval.lowIntent = intent;
    }
    if (outcome == IntentOutcome::Breaks && impulse < interval.high) {
        interval.high = impulse;
        interval.highIntent = intent;
    }
}

std::string eventText(IntentOutcome outcome, const DropIntent& drop) {
    return (outcome == IntentOutcome::Survives ? "survives a drop of " : "breaks in a drop of ") +
           messageText(drop.height) + " m";
}

std::string eventText(IntentOutcome outcome, const HitIntent& hit) {
    return (outcome == IntentOutcome::Survives ? "survives being hit by " : "breaks when hit by ") +
           messageText(hit.mass) + " kg at " + messageText(hit.speed) + " m/s";
}

}  // namespace

std::optional<double> ThresholdInterval::suggested() const {
    if (isEmpty() || (lowIntent == kNone && highIntent == kNone)) return std::nullopt;
    if (lowIntent == kNone) return high / kRoom;
    if (highIntent == kNone) return low * kRoom;
    return std::sqrt(low) * std::sqrt(high);
}

Result<ThresholdInterval> thresholdInterval(const Project& project, const PlayAsset& asset) {
    const Asset* authored = findAsset(project, asset.bake->asset);
    RUBBLE_ASSERT(authored != nullptr);
    ThresholdInterval interval;
    for (const Intent& intent : authored->intents) {
        const Result<double> impulse = intentImpulse(project, asset, intent);
        if (!impulse) return ofAsset(*authored, impulse.error());
        interval.impulses.push_back(*impulse);
        narrow(interval, intent.outcome, static_cast<std::uint32_t>(interval.impulses.size() - 1));
    }
    return interval;
}

std::string intentText(const Intent& intent) {
    return std::visit([&](const auto& event) { return eventText(intent.outcome, event); }, intent.event);
}

std::optional<std::string> conflictText(const Asset& asset, const ThresholdInterval& interval) {
    if (!interval.isEmpty()) return std::nullopt;
    const std::string breaks = '"' + intentText(asset.intents[interval.highIntent]) + '"';
    if (interval.high == 0.0) return breaks + " cannot be had: so slow a touch does no damage.";
    const std::string survives = '"' + intentText(asset.intents[interval.lowIntent]) + '"';
    const double apart = interval.low - interval.high;
    return survives + " needs a threshold above " + impulseText(interval.low) + ", " + breaks + " one of at most " +
           impulseText(interval.high) + ": they are " + impulseText(apart) + " (" +
           figureText(100.0 * apart / interval.high) + " %) apart.";
}

std::string intervalText(const ThresholdInterval& interval) {
    const std::string low = "above " + impulseText(interval.low);
    if (interval.highIntent == kNone) return interval.lowIntent == kNone ? "any" : low;
    const std::string high = "at most " + impulseText(interval.high);
    return interval.lowIntent == kNone ? high : low + " and " + high;
}

std::string impulseText(double impulse) { return figureText(impulse) + " N s"; }

}  // namespace rubble
