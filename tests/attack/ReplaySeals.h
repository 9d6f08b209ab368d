#pragma once

#include <string>
#include <string_view>

namespace rubble::attack {

/// Returns the text of a replay with its seals made anew, as an attacker would, so that a change reaches what comes
/// behind them; the text as it is where its lists cannot be read. Of repeated keys only the last stays.
std::string withReplaySeals(std::string_view replay);

}  // namespace rubble::attack
