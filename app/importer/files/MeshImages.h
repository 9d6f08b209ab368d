#pragma once

#include "app/importer/files/MeshFiles.h"
#include "core/geometry/mesh/SourceScene.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace rubble {

/// Adds the images that materials refer to to a scene, each once. One that is not read becomes a note: of the files if
/// it is a file that is not opened, else of the scene.
class MeshImages {
public:
    MeshImages(MeshFiles& files, SourceScene& scene) : m_files(files), m_scene(scene) {}

    /// Returns the index of the image file that a mesh calls `name`: relative to `folder`, which is relative to that of
    /// the mesh, else relative to that of the mesh, else the file of that name beside the mesh. Nothing if it is not
    /// read.
    std::optional<std::uint32_t> file(const std::string& name, const std::string& folder = {});
    /// Returns the index of an image that is a part of another file; `key` tells it from others. Nothing if it is not
    /// read.
    std::optional<std::uint32_t> embedded(const std::string& key, const std::string& name, std::string_view bytes);
    /// Notes that an image is not read: `why` is the end of a sentence.
    void note(const std::string& name, const std::string& why);

private:
    std::optional<std::uint32_t> add(const std::string& key, const std::string& name, std::string bytes);

    MeshFiles& m_files;
    SourceScene& m_scene;
    std::map<std::string, std::optional<std::uint32_t>> m_known;  // by the file or the key
    std::size_t m_bytes = 0;                                      // of all images
};

}  // namespace rubble
