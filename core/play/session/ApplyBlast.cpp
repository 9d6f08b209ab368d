#include "core/play/session/ApplyBlast.h"

#include "core/base/MessageText.h"
#include "core/play/breaking/BondBreaking.h"
#include "core/play/breaking/Swap.h"
#include "core/play/state/InputDiagnostics.h"
#include "core/play/state/SessionBodies.h"

#include <algorithm>
#include <optional>

namespace rubble {
namespace {

/// The break of a body by its impulse, which is reported; nothing if it stays whole.
std::optional<PendingBreak> breakBy(SessionParts& parts, const BlastImpulse& push) {
    const PlayBody& body = *findBody(parts.state(), static_cast<std::uint32_t>(parts.world().tag(push.body)));
    if (body.fracture() == nullptr) return std::nullopt;
    const double size = glm::length(push.impulse), threshold = thresholdOf(parts.state(), parts.scene(), body);
    parts.state().events.impacts.push_back({body.number, size, threshold, push.point});
    if (!parts.state().hasDestruction || size < threshold) return std::nullopt;
    PendingBreak broken = pendingBreak(parts, body);
    broken.event.impact = size;
    broken.event.point = push.point;
    broken.event.normal = push.impulse / size;
    return broken;
}

}  // namespace

void applyBlast(SessionParts& parts, const std::string& name, const Blast& blast) {
    const Vec3 origin = parts.world().blastOrigin(blast.at);
    if (parts.state().hasDestruction) blastBonds(parts, origin, blast);
    const auto pushesNow = [&] { return parts.world().blast(origin, blast.radius, blast.impulse); };
    std::vector<BlastImpulse> pushes = pushesNow();
    std::vector<PendingBreak> breaks;
    for (const BlastImpulse& push : pushes) {
        if (std::optional<PendingBreak> broken = breakBy(parts, push)) breaks.push_back(std::move(*broken));
    }
    if (!breaks.empty()) {
        std::ranges::sort(breaks, {}, [](const PendingBreak& pending) { return pending.event.body.number; });
        applyBreaks(parts, std::move(breaks));
        pushes = pushesNow();
    }
    EnergyEntry entry{.change = EnergyChange::Blast};
    for (const BlastImpulse& push : pushes) {
        if (parts.world().kind(push.body) != BodyKind::Dynamic) continue;
        MovingMass pushed = movingMass(parts.world(), push.body);
        const double before = pushed.kineticEnergy();
        pushed.applyImpulse(push.impulse, push.point);
        if (!applyImpulse(parts, push.body, push.impulse, push.point, "Saved throw " + quotedName(name))) continue;
        entry.before += before;
        entry.given += pushed.kineticEnergy() - before;
        entry.after += kineticEnergy(parts.world(), push.body);
    }
    parts.state().events.energy.push_back(entry);
}

}  // namespace rubble
