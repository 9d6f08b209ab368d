#include "core/play/scene/JoinedSupport.h"

#include "core/play/scene/SupportSpread.h"

#include <algorithm>
#include <numeric>

namespace rubble {

NodeFractions supportFractions(const std::map<Id, JoinedStructure>& joined, const NodeFractions& limits) {
    const SupportSpread support(joined, limits);
    NodeFractions fractions;
    for (const auto& [instance, one] : joined) fractions[instance] = support.fractionsOf(instance);
    return fractions;
}

NodeFractions joinedSupportLimits(const std::map<Id, JoinedStructure>& atStart) {
    NodeFractions limits = supportFractions(atStart);
    for (auto& [instance, fractions] : limits) {
        for (double& fraction : fractions) fraction = std::max(fraction, 1.0);
    }
    return limits;
}

JoinedStructure joinedAtStart(const PlayStructure& structure, Vec3 up) {
    JoinedStructure joined{&structure, structure.initialDamage, {}, up};
    joined.held.resize(structure.nodeCount());
    std::iota(joined.held.begin(), joined.held.end(), 0u);
    return joined;
}

}  // namespace rubble
