#pragma once

#include "core/asset/project/Surface.h"
#include "core/base/image/EncodedImage.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// The base colour of an asset's outside: an image that is multiplied by the material's colour. Its texture coordinates
/// are those of the outside faces; it repeats beyond [0, 1].
struct Texture {
    std::string name;                           // of the image's file, without folders
    std::shared_ptr<const EncodedImage> image;  // never null; shared by assets
    std::vector<std::uint32_t> materials;       // of the surface, that have the image; ascending, without repetition
    bool covers(std::uint32_t material) const;
    bool operator==(const Texture& other) const;
};

/// `checker.png (512 × 512)`
std::string textureText(const Texture& texture);

/// Returns the first error in a texture, if there is one: a name that is empty, too long or not one of a file in
/// UTF-8; no materials, or ones that the surface does not have. `surface`: null for a prism without one. `owner`:
/// `Asset 3 "wall"`.
std::optional<std::string> textureFault(const std::string& owner, const Texture& texture, const Surface* surface);

}  // namespace rubble
