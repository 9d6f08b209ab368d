#pragma once

#include "core/base/Result.h"
#include "core/fracture/sampling/GreyImage.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace rubble {

/// The maximum width and height of a picture file, in pixels.
inline constexpr std::uint32_t kMaxPictureSide = 8192;

/// An image for a density layer, from a picture file.
struct DensityPicture {
    std::shared_ptr<const GreyImage> image;  // at most GreyImage::kMaxSide pixels a side
    std::string note;                        // a sentence if the picture was larger; else empty
};

/// Loads a PNG file of any colour type as luminance and opacity, with 8 or 16 bits for each as in the file, reduced if
/// it is larger than GreyImage::kMaxSide pixels a side.
///
/// Errors: those of readFile(); BadInput, with the file's name, if it is no PNG file or damaged; those of
/// checkPictureSize().
Result<DensityPicture> loadDensityPicture(const std::filesystem::path& path);

// For readers of other formats.

bool isPng(std::string_view bytes);

/// Decodes a PNG file, whose size is checked before its pixels are read. `name` is the file's, for messages. The size
/// of the image is that of the picture.
///
/// Errors: BadInput if it is damaged; those of checkPictureSize().
Result<GreyImage> greyImageOfPng(std::string_view bytes, const std::string& name);

/// Errors: BadInput above kMaxPictureSide.
Status checkPictureSize(const std::string& name, std::uint64_t width, std::uint64_t height);

/// An image of the size of its picture, reduced if necessary. Without an opacity channel if it is opaque.
DensityPicture densityPictureOf(GreyImage image, const std::string& name);

}  // namespace rubble
