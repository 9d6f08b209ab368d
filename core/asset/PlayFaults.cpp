#include "core/asset/PlayFaults.h"

#include "core/asset/ProjectFaults.h"
#include "core/asset/Quantities.h"

namespace rubble {
namespace {

using Sentence = std::optional<std::string>;

Sentence cutFault(const std::string& owner, const CutAtImpact& cut) {
    if (cut.pieces < CutAtImpact::kFewestPieces || cut.pieces > CutAtImpact::kMostPieces) {
        return owner + ": where it is hit it is cut into " + std::to_string(cut.pieces) +
               " pieces, but there must be " + std::to_string(CutAtImpact::kFewestPieces) + " to " +
               std::to_string(CutAtImpact::kMostPieces) + ".";
    }
    return quantityFault(owner, {{"reach of the cut where it is hit", cut.reach, Range::AboveZero}});
}

Sentence eventFault(const std::string& owner, const DropIntent& drop) {
    return quantityFault(owner, {{"height", drop.height, Range::AboveZero}});
}

Sentence eventFault(const std::string& owner, const HitIntent& hit) {
    return quantityFault(owner, {{"mass", hit.mass, Range::AboveZero}, {"speed", hit.speed, Range::AboveZero}});
}

Sentence actionFault(const std::string& owner, const Throw& thrown) {
    if (Sentence fault = vectorFault(owner, "start", thrown.from)) return fault;
    if (Sentence fault = vectorFault(owner, "aim", thrown.to)) return fault;
    if (thrown.from == thrown.to) return owner + ": it starts where it aims, so that it has no direction.";
    return quantityFault(owner, {{"size in x", thrown.size.x, Range::AboveZero},
                                 {"size in y", thrown.size.y, Range::AboveZero},
                                 {"size in z", thrown.size.z, Range::AboveZero},
                                 {"mass", thrown.mass, Range::AboveZero},
                                 {"speed", thrown.speed, Range::ZeroOrAbove}});
}

Sentence actionFault(const std::string& owner, const Hammer& hammer) {
    if (Sentence fault = vectorFault(owner, "place", hammer.at)) return fault;
    return vectorFault(owner, "impulse", hammer.impulse);
}

Sentence actionFault(const std::string& owner, const Explosion& explosion) {
    if (Sentence fault = vectorFault(owner, "place", explosion.at)) return fault;
    return quantityFault(
        owner, {{"impulse", explosion.impulse, Range::ZeroOrAbove}, {"radius", explosion.radius, Range::AboveZero}});
}

}  // namespace

std::optional<std::string> playFault(const Asset& asset) {
    const std::string owner = ownerText("Asset", asset.id, asset.name);
    if (asset.cutAtImpact) {
        if (Sentence fault = cutFault(owner, *asset.cutAtImpact)) return fault;
    }
    for (std::size_t k = 0; k < asset.intents.size(); ++k) {
        const std::string intent = owner + ": intent " + std::to_string(k);
        const auto fault = [&](const auto& event) { return eventFault(intent, event); };
        if (Sentence found = std::visit(fault, asset.intents[k].event)) return found;
    }
    return std::nullopt;
}

std::optional<std::string> faultOf(const Debris& debris) {
    if (debris.mostPieces == 0u) return "The debris: the most pieces are 0, but they must be at least 1.";
    return quantityFault("The debris", {{"lifetime", debris.lifetime.value_or(1.0), Range::AboveZero},
                                        {"fade", debris.fade, Range::ZeroOrAbove}});
}

std::optional<std::string> faultOf(const Shot& shot) {
    const std::string owner = ownerText("Shot", shot.id, shot.name);
    if (Sentence fault = quantityFault(owner, {{"time", shot.time, Range::ZeroOrAbove}})) return fault;
    return std::visit([&](const auto& action) { return actionFault(owner, action); }, shot.action);
}

std::optional<std::string> faultOf(const PlayTest& test) {
    const std::string owner = ownerText("Play-test", test.id, test.name);
    if (Sentence fault = quantityFault(owner, {{"duration", test.duration, Range::AboveZero}})) return fault;
    for (const Expectation& expectation : test.expectations) {
        if (Sentence fault = quantityFault(owner, {{"expected value", expectation.value, Range::Finite}})) return fault;
    }
    return std::nullopt;
}

}  // namespace rubble
