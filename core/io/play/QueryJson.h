#pragma once

#include "core/play/queries/WouldFall.h"

#include <span>
#include <string>

namespace rubble {

/// What falls without bodies and fragments, as JSON: names, also of fragments of bonded bodies, masses in kg, times in
/// s. The session must be the one that was asked.
std::string wouldFallJson(const Session& session, std::span<const BodyPart> removed, const Collapse& collapse);

/// Boxes that changed since a step, as JSON, in metres.
std::string changedBoxesJson(std::uint64_t since, std::uint64_t step, std::span<const Box3> boxes);

}  // namespace rubble
