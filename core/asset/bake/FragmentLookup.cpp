#include "core/asset/bake/FragmentLookup.h"

#include "core/fracture/fragments/FragmentName.h"

namespace rubble {
namespace {

/// The fragment of a fracture with the last name of a path; kNone if there is none.
std::uint32_t findByName(const FragmentPath& path, const BakedFracture& fracture) {
    const std::optional<PieceName> name = pieceNameOf(path);
    const std::string text = path.substr(path.rfind('/') + 1);
    for (std::uint32_t k = 0; name && k < fracture.fragments.count(); ++k) {
        const Fragment fragment = fracture.fragments[k];
        // Compare the seed first: names are slower to build.
        if (cellId(fragment, fracture.seeds.ids) != name->seed) continue;
        if (fragmentName(fragment, fracture.seeds.ids) == text) return fracture.first + k;
    }
    return kNone;
}

}  // namespace

std::optional<std::uint32_t> fragmentAt(const Bake& bake, const FragmentPath& path) {
    if (path.empty()) return kNone;
    const std::optional<std::uint32_t> parent = fragmentAt(bake, parentOf(path));
    const BakedFracture* fracture = parent ? bake.fractureOf(*parent) : nullptr;
    const std::uint32_t found = fracture ? findByName(path, *fracture) : kNone;
    return found == kNone ? std::nullopt : std::optional(found);
}

}  // namespace rubble
