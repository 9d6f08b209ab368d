#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace rubble {

/// Returns the position of the data of a binary PLY file if they begin with a line feed; `start`: of the file.
///
/// assimp 5.2 takes that byte for the second half of the header's last line end, drops it and crashes on what follows.
/// It reads such a file correctly if there is one more line feed.
std::optional<std::size_t> plyDataAtLineFeed(std::string_view start);

}  // namespace rubble
