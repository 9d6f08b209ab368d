#pragma once

#include "core/base/Random.h"
#include "docs/formats/rubble_pack.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rubble::attack {

/// Reads texts by a function of rubble_pack.hpp: parse(), parseScene() … Returns whether it read them. A refusal must
/// be a sentence: else `wrong` is set.
template <class T>
bool isReadBy(bool (*parse)(std::string_view, T&, std::string&), std::string_view bytes, T& result,
              std::optional<std::string>& wrong) {
    std::string fault;
    if (parse(bytes, result, fault)) return true;
    if (fault.empty() || fault.back() != '.') wrong = "The header refuses without a sentence: \"" + fault + "\".";
    return false;
}

/// Does with a pack that rubble_pack.hpp read what engines do: asks for its bodies, hits, collapses and weighs the
/// structures of its fractures, and passes their damages on. Returns the first fault, or nothing.
std::optional<std::string> packUseFault(const rubble_pack::Pack& pack, Random& random);

/// The same of a scene and its packs, over mortar. Sets `isUsed` to whether they fit together; else the refusal must
/// be a sentence.
std::optional<std::string> sceneUseFault(const rubble_pack::Scene& scene, const std::vector<rubble_pack::Pack>& packs,
                                         Random& random, bool& isUsed);

/// Plays a log of events in random steps.
std::optional<std::string> eventsUseFault(const rubble_pack::EventLog& log, Random& random);

}  // namespace rubble::attack
