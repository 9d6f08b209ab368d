#include "core/asset/PlayFaults.h"

#include "core/asset/ProjectFaults.h"
#include "core/asset/Quantities.h"

namespace rubble {
namespace {

using Sentence = std::optional<std::string>;

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
