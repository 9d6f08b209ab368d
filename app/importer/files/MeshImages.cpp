#include "app/importer/files/MeshImages.h"

#include "app/importer/files/AssimpValues.h"
#include "core/base/MessageText.h"
#include "core/base/limits/ImageLimits.h"

#include <algorithm>
#include <filesystem>

namespace rubble {
namespace {

/// The last part of a path in the style of any system.
std::string fileNameOf(const std::string& path) { return path.substr(path.find_last_of("/\\") + 1); }

/// The name that an image has without its suffix, and the suffix of its type.
std::string imageName(const std::string& path, const EncodedImage& image) {
    const std::string name = lineOf(std::filesystem::path(fileNameOf(path)).stem().string());
    return (name.empty() ? "texture" : name) + std::string(image.suffix());
}

}  // namespace

std::optional<std::uint32_t> MeshImages::file(const std::string& name, const std::string& folder) {
    std::string found = name;
    for (const std::string& place : {(std::filesystem::path(folder) / name).string(), name, fileNameOf(name)}) {
        if (place.empty() || !m_files.Exists(place.c_str())) continue;
        found = place;
        break;
    }
    if (const auto known = m_known.find(found); known != m_known.end()) return known->second;
    std::optional<std::string> bytes = m_files.content(found, kMaxImageBytes);
    return bytes ? add(found, name, std::move(*bytes)) : m_known[found] = std::nullopt;
}

std::optional<std::uint32_t> MeshImages::embedded(const std::string& key, const std::string& name,
                                                  std::string_view bytes) {
    if (const auto known = m_known.find(key); known != m_known.end()) return known->second;
    return add(key, name, std::string(bytes));
}

void MeshImages::note(const std::string& name, const std::string& why) {
    if (m_scene.notes.size() < kMaxNotes)
        m_scene.notes.push_back("The image " + quotedName(lineOf(name)) + " is not read: it " + why + ".");
}

std::optional<std::uint32_t> MeshImages::add(const std::string& key, const std::string& name, std::string bytes) {
    std::optional<std::uint32_t>& index = m_known[key];
    Result<EncodedImage> image = EncodedImage::of(std::move(bytes));
    if (!image) {
        note(name, image.error().message);
    } else if (m_bytes + image->bytes().size() > kMaxMeshImageBytes) {
        note(name, "and the images before it are larger than " + std::to_string(kMaxMeshImageBytes >> 20) +
                       " MiB together; scale them down, or import a part of the file");
    } else {
        m_bytes += image->bytes().size();
        index = static_cast<std::uint32_t>(m_scene.images.size());
        std::string shown = imageName(name, *image);
        m_scene.images.push_back({std::move(shown), std::move(*image)});
    }
    return index;
}

}  // namespace rubble
