#pragma once

#include "app/importer/files/Descriptor.h"
#include "core/base/Result.h"

#include <assimp/IOSystem.hpp>

#include <cstdint>
#include <memory>
#include <optional>
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

/// Why a file is not read to which a mesh refers.
enum class Refusal { Outside, LinkOutside, LinkLoop, AnyLink, NotAFile, Missing, TooLarge };

struct RefusedFile {
    std::string name;  // as the mesh has it
    Refusal reason = Refusal::Outside;
};

/// Returns a refusal as the end of a sentence: refers to "wall.bin", which does not exist.
std::string refusalText(const RefusedFile& file);

/// The files that a mesh may refer to, for reading only: the mesh and regular files in its folder and below. Links that
/// are absolute or lead out of the folder are not followed. Names are relative to the folder. Text files in UTF-16
/// appear as UTF-8.
class MeshFiles final : public Assimp::IOSystem {
public:
    MeshFiles(MeshPlace place, FileLog log) : m_place(std::move(place)), m_log(log) {}

    bool Exists(const char* name) const override;
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* name, const char* mode) override;
    void Close(Assimp::IOStream* stream) override;

    /// Returns the content of the mesh.
    ///
    /// Errors: throws MeshError; Io if it cannot be opened.
    std::string meshContent();
    /// Returns the content of the file that a mesh calls `name`: the file of that name, else the one of the name with
    /// its percent escapes decoded once, else with / for \. Nothing if it is not read, or has more than `most` bytes;
    /// refused() says why.
    std::optional<std::string> content(const std::string& name, std::size_t most = SIZE_MAX);

    /// The files that were not read, in the order in which they were refused, each once.
    const std::vector<RefusedFile>& refused() const { return m_refused; }
    const std::string& meshName() const { return m_place.name; }

private:
    std::shared_ptr<const Descriptor> opened(const std::string& name);
    std::string existingName(const std::string& name) const;
    void refuse(const std::string& name, Refusal reason);

    MeshPlace m_place;
    FileLog m_log;
    std::vector<RefusedFile> m_refused;
};

}  // namespace rubble
