#include "core/play/state/InputDiagnostics.h"

#include "core/base/Assert.h"
#include "core/physics/state/VerifyBody.h"
#include "core/play/state/SessionBodies.h"

#include <utility>

namespace rubble {

void addUnapplied(SessionParts& parts, const PlayBody* body, std::string message) {
    DiagnosticPlace place = body != nullptr ? placeOf(*body) : DiagnosticPlace{};
    parts.state().events.diagnostics.push_back(
        diagnostic(DiagnosticCode::UnappliedInput, std::move(place), std::move(message)));
}

void reportRefused(SessionParts& parts, const PlayBody* body, const std::string& input, const Status& status) {
    if (!status) addUnapplied(parts, body, input + ": " + status.error().message);
}

bool isApplicable(SessionParts& parts, const PlayBody& body, Vec3 impulse, Vec3 point, const std::string& cause) {
    const std::optional<std::string> fault = verifyImpulse(impulse, point);
    if (fault) addUnapplied(parts, &body, cause + ": " + *fault);
    return !fault;
}

bool applyImpulse(SessionParts& parts, BodyId body, Vec3 impulse, Vec3 point, const std::string& cause) {
    const PlayBody* const owner = findBody(parts.state(), static_cast<std::uint32_t>(parts.world().tag(body)));
    RUBBLE_ASSERT(owner != nullptr);
    if (!isApplicable(parts, *owner, impulse, point, cause)) return false;
    const Status applied = parts.world().applyImpulse(body, impulse, point);
    RUBBLE_ASSERT(applied.hasValue());
    return true;
}

}  // namespace rubble
