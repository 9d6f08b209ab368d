#pragma once

#include "app/importer/Descriptor.h"
#include "core/base/Result.h"

#include <assimp/IOSystem.hpp>

#include <memory>
#include <string>
#include <vector>

namespace rubble {

/// A mesh file and the folder that it lies in.
struct MeshPlace {
    std::string name;  // of the file, without its folder
    std::shared_ptr<const Descriptor> file;
    std::shared_ptr<const Descriptor> folder;
};

/// Opens a mesh file and its folder.
///
/// Errors: Io if it cannot be opened or is not a regular file.
Result<MeshPlace> openMesh(const std::string& path);

/// Whether each opened and refused file is named on standard error.
enum class FileLog { Off, On };

/// The files that assimp may open, for reading only: the mesh and regular files in its folder and below. Links that
/// lead out of the folder are not followed. Names are relative to the folder. Text files in UTF-16 appear as UTF-8.
class MeshFiles final : public Assimp::IOSystem {
public:
    MeshFiles(MeshPlace place, FileLog log) : m_place(std::move(place)), m_log(log) {}

    bool Exists(const char* name) const override;
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* name, const char* mode) override;
    void Close(Assimp::IOStream* stream) override;

    /// The names that lead out of the folder, in the order in which they were refused.
    const std::vector<std::string>& refused() const { return m_refused; }

private:
    std::shared_ptr<const Descriptor> opened(const std::string& name);
    void refuse(const std::string& name);

    MeshPlace m_place;
    FileLog m_log;
    std::vector<std::string> m_refused;
};

}  // namespace rubble
