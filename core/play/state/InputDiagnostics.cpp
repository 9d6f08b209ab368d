#include "core/play/state/InputDiagnostics.h"

#include <utility>

namespace rubble {

void addUnapplied(const SessionParts& parts, const PlayBody* body, std::string message) {
    DiagnosticPlace place = body != nullptr ? placeOf(*body) : DiagnosticPlace{};
    parts.state.events.diagnostics.push_back(
        diagnostic(DiagnosticCode::UnappliedInput, std::move(place), std::move(message)));
}

void reportRefused(const SessionParts& parts, const PlayBody* body, const std::string& input, const Status& status) {
    if (!status) addUnapplied(parts, body, input + ": " + status.error().message);
}

}  // namespace rubble
