#include "core/asset/FragmentPlace.h"

#include "core/fracture/PatternPartition.h"

namespace rubble {
namespace {

/// A piece of a breaking by the last name in a path; kNone where there is none of this name.
std::uint32_t pieceNamed(const FragmentPath& path, const BakedBreaking& breaking) {
    const std::optional<PieceName> name = pieceNameOf(path);
    const std::string text = path.substr(path.rfind('/') + 1);
    const Partition& partition = breaking.fragments.partition;
    for (std::uint32_t k = 0; name && k < breaking.fragments.count(); ++k) {
        const std::uint32_t piece = breaking.fragments[k].piece();
        // The seed is compared first: names take longer to make.
        if (cellId(partition, piece, breaking.seeds.ids) != name->seed) continue;
        if (pieceName(partition, piece, breaking.seeds.ids) == text) return breaking.first + k;
    }
    return kNone;
}

}  // namespace

bool isWithin(const FragmentPath& path, const FragmentPath& place) {
    if (place.empty() || path == place) return true;
    return path.size() > place.size() && path.starts_with(place) && path[place.size()] == '/';
}

FragmentPath pieceOf(const FragmentPath& place, const FragmentPath& path) {
    return path.substr(0, path.find('/', place.empty() ? 0 : place.size() + 1));
}

std::optional<std::uint32_t> fragmentAt(const Bake& bake, const FragmentPath& path) {
    if (path.empty()) return kNone;
    const std::optional<std::uint32_t> parent = fragmentAt(bake, parentOf(path));
    const BakedBreaking* breaking = parent ? bake.breakingOf(*parent) : nullptr;
    const std::uint32_t piece = breaking ? pieceNamed(path, *breaking) : kNone;
    return piece == kNone ? std::nullopt : std::optional(piece);
}

}  // namespace rubble
