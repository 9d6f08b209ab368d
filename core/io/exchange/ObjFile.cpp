#include "core/io/exchange/ObjFile.h"

#include "core/io/exchange/ObjWriter.h"

namespace rubble {
namespace {

constexpr const char* kHeader = "Rubble 1: metres, y up";

const MeshMaterial& materialOf(const MeshFace& face, const MeshMaterials& materials) {
    return face.side == FaceSide::Inside ? materials.inside : materials.outside[face.material];
}

void addPart(ObjWriter& lines, const MeshPart& part, const MeshMaterials& materials, PartPlacement place) {
    const Mesh& mesh = part.mesh;
    lines.addNamed("o", part.name);
    lines.addNamed("g", part.name);
    const Vec3 offset = place == PartPlacement::Assembled ? part.offset : Vec3{0.0, 0.0, 0.0};
    for (const Vec3 position : mesh.positions) lines.addPosition(position + offset);
    for (const Vec2 uv : mesh.uvs) lines.addUv(uv);
    for (const Vec3 normal : mesh.normals) lines.addNormal(normal);
    lines.beginFaces(mesh);
    const MeshMaterial* used = nullptr;
    for (const MeshFace& face : mesh.faces) {
        const MeshMaterial* material = &materialOf(face, materials);
        if (material != used) lines.addNamed("usemtl", material->name);
        used = material;
        lines.addFace(mesh, face);
    }
}

/// Returns the estimated size of a file in bytes, rather too large than too small.
std::size_t expectedSize(std::span<const MeshPart> parts) {
    std::size_t size = 256;
    for (const MeshPart& part : parts) {
        const Mesh& mesh = part.mesh;
        size += 128 + 64 * mesh.positions.size() + 44 * mesh.uvs.size() + 24 * mesh.normals.size() +
                20 * mesh.corners.size() + 4 * mesh.faces.size();
    }
    return size;
}

void addMaterial(std::string& text, const MeshMaterial& material) {
    text += "newmtl " + material.name + "\nKd";
    for (const double part : {material.colour.red, material.colour.green, material.colour.blue}) {
        text += ' ';
        appendNumber(text, part);
    }
    if (material.opacity < 1.0) {
        text += "\nd ";
        appendNumber(text, material.opacity);
    }
    text += "\nillum 1\n";
}

}  // namespace

std::string objFile(std::span<const MeshPart> parts, const MeshMaterials& materials, PartPlacement place,
                    const std::string& materialFile) {
    ObjWriter lines(expectedSize(parts));
    lines.addNamed("#", kHeader);
    lines.addNamed("mtllib", materialFile);
    lines.addNamed("s", "off");
    for (const MeshPart& part : parts) addPart(lines, part, materials, place);
    return std::move(lines).text();
}

std::string mtlFile(const MeshMaterials& materials) {
    std::string text = "# ";
    text.append(kHeader).push_back('\n');
    for (const MeshMaterial& material : materials.outside) addMaterial(text, material);
    addMaterial(text, materials.inside);
    return text;
}

}  // namespace rubble
