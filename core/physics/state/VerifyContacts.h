#pragma once

#include "core/physics/state/WorldState.h"

#include <optional>
#include <string>

namespace rubble {

/// The part of verifyState() about contacts, sleeping islands and stored lanes. Bodies and proxies must be verified.
std::optional<std::string> verifyContacts(const WorldState& state);

/// The name of a table and the number of an element.
std::string placeIn(const char* table, std::size_t element, const char* field = nullptr);

/// The entry of a list of free elements that is not one, or occurs twice, or the list if one is missing; nothing if it
/// has exactly those that are free, each once.
std::optional<std::string> verifyFree(const char* list, const std::vector<std::uint32_t>& free,
                                      const std::vector<bool>& isFree);

}  // namespace rubble
