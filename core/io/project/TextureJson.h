#pragma once

#include "core/asset/project/Project.h"
#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"

#include <memory>
#include <vector>

namespace rubble {

/// The images of a project's textures, each once, in the order of the assets.
using ImageList = std::vector<std::shared_ptr<const EncodedImage>>;
ImageList imagesOf(const Project& project);

/// Writes an asset's texture: its name, the index of its image in `images`, and its materials.
void writeTexture(JsonWriter& json, const Texture& texture, const ImageList& images);
/// Writes images as base64.
void writeImages(JsonWriter& json, const ImageList& images);

/// Reads images.
///
/// Errors, in the document: base64 that is invalid, a type that is not that of the bytes, those of EncodedImage.
ImageList readImages(const JsonValue& value);
/// Reads a texture.
///
/// Errors, in the document: an image that is not in `images`.
Texture readTexture(const JsonValue& value, const ImageList& images);

}  // namespace rubble
