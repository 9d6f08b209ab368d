#include "app/importer/PlyData.h"

namespace rubble {

std::optional<std::size_t> plyDataAtLineFeed(std::string_view start) {
    constexpr std::string_view kEnd = "\nend_header\n";
    if (!start.starts_with("ply\n")) return std::nullopt;
    const std::size_t end = start.find(kEnd);
    if (end == std::string_view::npos || start.find("\nformat binary_") > end) return std::nullopt;
    const std::size_t data = end + kEnd.size();
    if (data >= start.size() || start[data] != '\n') return std::nullopt;
    return data;
}

}  // namespace rubble
