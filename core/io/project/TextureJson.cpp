#include "core/io/project/TextureJson.h"

#include "core/io/text/Base64.h"

#include <algorithm>
#include <array>

namespace rubble {
namespace {

constexpr std::array<std::string_view, 2> kMediaTypes{"image/png", "image/jpeg"};  // by ImageType

auto findImage(const ImageList& images, const EncodedImage& image) {
    return std::ranges::find_if(images, [&](const auto& one) { return one.get() == &image || *one == image; });
}

void writeImage(JsonWriter& json, const std::shared_ptr<const EncodedImage>& image) {
    json.openObject();
    json.text("type", image->mediaType());
    json.text("base64", base64(image->bytes()));
    json.close();
}

std::shared_ptr<const EncodedImage> readImage(const JsonValue& value) {
    value.requireObject({"type", "base64"});
    const std::size_t type = value["type"].oneOf(kMediaTypes);
    const std::string text = value["base64"].text();
    if (text.empty()) value["base64"].fail("expected an image");
    std::optional<std::string> bytes = base64Decoded(text);
    if (!bytes) {
        value["base64"].fail("expected base64: letters, digits, + and /");
        return nullptr;
    }
    Result<EncodedImage> image = EncodedImage::of(std::move(*bytes));
    if (!image) {
        value.fail("the image " + image.error().message);
        return nullptr;
    }
    if (image->type() != static_cast<ImageType>(type))
        value["type"].fail("the image is " + std::string(image->mediaType()));
    return std::make_shared<const EncodedImage>(std::move(*image));
}

std::uint32_t readIndex(const JsonValue& value) { return value.index(); }

}  // namespace

ImageList imagesOf(const Project& project) {
    ImageList images;
    for (const Asset& asset : project.assets) {
        if (asset.texture && findImage(images, *asset.texture->image) == images.end())
            images.push_back(asset.texture->image);
    }
    return images;
}

void writeTexture(JsonWriter& json, const Texture& texture, const ImageList& images) {
    json.openObject("texture", JsonLayout::Inline);
    json.text("name", texture.name);
    json.wholeNumber("image", static_cast<std::uint64_t>(findImage(images, *texture.image) - images.begin()));
    json.wholeNumbers("materials", texture.materials);
    json.close();
}

void writeImages(JsonWriter& json, const ImageList& images) { json.list("images", images, writeImage); }

ImageList readImages(const JsonValue& value) { return value.list(readImage); }

Texture readTexture(const JsonValue& value, const ImageList& images) {
    value.requireObject({"name", "image", "materials"});
    Texture texture{.name = value["name"].text(), .image = nullptr, .materials = value["materials"].list(readIndex)};
    const std::uint32_t index = value["image"].index();
    if (index < images.size()) texture.image = images[index];
    if (!texture.image)
        value["image"].fail("refers to image " + std::to_string(index) + " of " + std::to_string(images.size()));
    return texture;
}

}  // namespace rubble
