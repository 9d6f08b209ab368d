#include "core/asset/project/FragmentPath.h"

#include <algorithm>
#include <charconv>
#include <vector>

namespace rubble {
namespace {

/// Splits a text at the separators.
std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

std::optional<std::uint32_t> parseNumber(std::string_view text) {
    std::uint32_t number = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool isPlain = text.size() == 1 || !text.starts_with('0');
    if (fault != std::errc{} || end != text.data() + text.size() || !isPlain) return std::nullopt;
    return number;
}

/// Parses "5.17", "5.17.1", "5.17+8.2" or "5.17+8.2.1".
std::optional<PieceName> parseName(std::string_view text) {
    PieceName name;
    const std::vector<std::string_view> ids = split(text, '+');
    for (std::size_t k = 0; k < ids.size(); ++k) {
        const std::vector<std::string_view> parts = split(ids[k], '.');
        const bool mayHavePart = k + 1 == ids.size();
        if (parts.size() < 2 || parts.size() > (mayHavePart ? 3u : 2u)) return std::nullopt;
        const auto layer = parseNumber(parts[0]), index = parseNumber(parts[1]);
        const auto part = parts.size() == 3 ? parseNumber(parts[2]) : std::optional{kNone};
        if (!layer || !index || !part) return std::nullopt;
        (k == 0 ? name.seed : name.cells.emplace_back()) = {*layer, *index};
        name.partOfCell = *part;
    }
    return name;
}

std::string textOf(const PieceName& name) {
    std::string text = name.seed.text();
    for (const SeedId& cell : name.cells) text += "+" + cell.text();
    return name.partOfCell == kNone ? text : text + "." + std::to_string(name.partOfCell);
}

}  // namespace

FragmentPath pathOfId(std::string_view fragmentId) {
    const std::size_t slash = fragmentId.find('/');
    return slash == std::string_view::npos ? FragmentPath() : FragmentPath(fragmentId.substr(slash + 1));
}

FragmentPath parentOf(const FragmentPath& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? FragmentPath() : path.substr(0, slash);
}

std::uint32_t levelOf(const FragmentPath& path) { return static_cast<std::uint32_t>(std::ranges::count(path, '/')); }

bool isWithin(const FragmentPath& path, const FragmentPath& ancestor) {
    if (ancestor.empty() || path == ancestor) return true;
    return path.size() > ancestor.size() && path.starts_with(ancestor) && path[ancestor.size()] == '/';
}

FragmentPath childOnPath(const FragmentPath& ancestor, const FragmentPath& path) {
    return path.substr(0, path.find('/', ancestor.empty() ? 0 : ancestor.size() + 1));
}

std::optional<PieceName> pieceNameOf(const FragmentPath& path) { return parseName(split(path, '/').back()); }

bool isFragmentPath(const FragmentPath& path) {
    return std::ranges::all_of(split(path, '/'), [](std::string_view name) { return parseName(name).has_value(); });
}

FragmentPath withLayers(const FragmentPath& path, const std::map<std::uint32_t, std::uint32_t>& layers) {
    FragmentPath result;
    for (const std::string_view text : split(path, '/')) {
        std::optional<PieceName> name = parseName(text);
        if (!name) return path;
        const auto rename = [&](SeedId& id) {
            const auto other = layers.find(id.layer);
            if (other != layers.end()) id.layer = other->second;
        };
        rename(name->seed);
        std::ranges::for_each(name->cells, rename);
        result += (result.empty() ? "" : "/") + textOf(*name);
    }
    return result;
}

}  // namespace rubble
