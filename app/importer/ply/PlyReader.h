#pragma once

#include <assimp/BaseImporter.h>
#include <assimp/importerdesc.h>

namespace rubble {

/// Reads PLY files for assimp, whose own reader crashes or runs on for ever if they are damaged, and reads bytes that
/// are not there.
///
/// Read are points, texture coordinates of vertices and of corners, polygons and triangle strips, as text or binary;
/// other elements and properties are skipped. Points have one material, which is white. An error names the element.
/// Source: Turk, "The PLY Polygon File Format", 1994.
class PlyReader final : public Assimp::BaseImporter {
public:
    bool CanRead(const std::string& file, Assimp::IOSystem* files, bool checkSignature) const override;
    const aiImporterDesc* GetInfo() const override;

protected:
    void InternReadFile(const std::string& file, aiScene* scene, Assimp::IOSystem* files) override;
};

}  // namespace rubble
