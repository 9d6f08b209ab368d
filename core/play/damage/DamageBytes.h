#pragma once

#include "core/play/damage/InstanceDamage.h"

#include <string_view>

namespace rubble {

inline constexpr std::uint8_t kDamageVersion = 1;

/// A damage as bytes for networks and files: at most 72, one for eight fractures or bonds, and four for each damaged
/// bond that holds. All fields are described in
/// docs/formats/state.md.
std::string damageBytes(const InstanceDamage& damage);

/// Reads what damageBytes() wrote.
///
/// Errors: BadInput for other bytes, or if any was changed; Unsupported for a newer version or an unknown kind.
Result<InstanceDamage> damageOfBytes(std::string_view bytes);

}  // namespace rubble
