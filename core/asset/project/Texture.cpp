#include "core/asset/project/Texture.h"

#include "core/base/MessageText.h"
#include "core/base/Utf8.h"

#include <algorithm>
#include <functional>

namespace rubble {

bool Texture::covers(std::uint32_t material) const { return std::ranges::find(materials, material) != materials.end(); }

bool Texture::operator==(const Texture& other) const {
    return name == other.name && materials == other.materials && (image == other.image || *image == *other.image);
}

std::string textureText(const Texture& texture) {
    return shownName(texture.name) + " (" + texture.image->sizeText() + ")";
}

std::optional<std::string> textureFault(const std::string& owner, const Texture& texture, const Surface* surface) {
    constexpr std::size_t kMaxName = 255;  // bytes, as of a file
    const std::string& name = texture.name;
    const bool isName = !name.empty() && name.size() <= kMaxName && isUtf8(name) &&
                        std::ranges::none_of(name, [](unsigned char letter) {
                            return letter < 0x20 || letter == 0x7f || letter == '/' || letter == '\\';
                        });
    if (!isName)
        return owner + ": the name of its texture must be that of a file: 1 to " + std::to_string(kMaxName) +
               " bytes in UTF-8, without folders and control characters.";
    const std::size_t count = surface == nullptr ? 1 : std::max<std::size_t>(surface->materials.size(), 1);
    const std::vector<std::uint32_t>& materials = texture.materials;
    if (materials.empty() || materials.back() >= count ||
        std::ranges::adjacent_find(materials, std::ranges::greater_equal()) != materials.end())
        return owner + ": its texture must be on materials of its surface, 0 to " + std::to_string(count - 1) +
               " in ascending order.";
    return std::nullopt;
}

}  // namespace rubble
