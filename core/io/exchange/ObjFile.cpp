#include "core/io/exchange/ObjFile.h"

#include "core/io/exchange/ObjWriter.h"

namespace rubble {
namespace {

constexpr const char* kVersion = "Rubble 1";

/// The name of a unit, and its number in a metre.
struct NamedUnit {
    const char* name;
    double perMetre;
};

NamedUnit namedUnit(ObjUnit unit) {
    if (unit == ObjUnit::Centimetre) return {"centimetres", 100.0};
    return unit == ObjUnit::Millimetre ? NamedUnit{"millimetres", 1000.0} : NamedUnit{"metres", 1.0};
}

/// Rotates y up to z up, so that the frame stays right-handed.
Vec3 rotated(Vec3 vector, UpAxis up) { return up == UpAxis::Y ? vector : Vec3(vector.x, 0.0 - vector.z, vector.y); }

const MeshMaterial& materialOf(const MeshFace& face, const MeshMaterials& materials) {
    return face.side == FaceSide::Inside ? materials.inside : materials.outside[face.material];
}

void addPart(ObjWriter& lines, const MeshPart& part, const MeshMaterials& materials, PartPlacement place,
             const ObjFrame& frame) {
    const Mesh& mesh = part.mesh;
    lines.addNamed("o", part.name);
    lines.addNamed("g", part.name);
    const Vec3 offset = place == PartPlacement::Assembled ? part.offset : Vec3{0.0, 0.0, 0.0};
    const double perMetre = namedUnit(frame.unit).perMetre;
    for (const Vec3 position : mesh.positions) lines.addPosition(rotated(perMetre * (position + offset), frame.up));
    for (const Vec2 uv : mesh.uvs) lines.addUv(uv);
    for (const Vec3 normal : mesh.normals) lines.addNormal(rotated(normal, frame.up));
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

void addMaterial(std::string& text, const MeshMaterial& material, const std::string& imageFile) {
    text += "newmtl " + material.name + "\nKd";
    for (const double part : {material.colour.red, material.colour.green, material.colour.blue}) {
        text += ' ';
        appendNumber(text, part);
    }
    if (material.opacity < 1.0) {
        text += "\nd ";
        appendNumber(text, material.opacity);
    }
    if (material.isTextured) text.append("\nmap_Kd ").append(imageFile);
    text += "\nillum 1\n";
}

}  // namespace

std::string objFile(std::span<const MeshPart> parts, const MeshMaterials& materials, PartPlacement place,
                    const std::string& materialFile, const ObjFrame& frame) {
    ObjWriter lines(expectedSize(parts));
    const char* up = frame.up == UpAxis::Y ? ", y up" : ", z up";
    lines.addNamed("#", kVersion + std::string(": ") + namedUnit(frame.unit).name + up);
    lines.addNamed("mtllib", materialFile);
    lines.addNamed("s", "off");
    for (const MeshPart& part : parts) addPart(lines, part, materials, place, frame);
    return std::move(lines).text();
}

std::string mtlFile(const MeshMaterials& materials) {
    std::string text = "# ";
    text.append(kVersion).push_back('\n');
    for (const MeshMaterial& material : materials.outside) addMaterial(text, material, materials.imageFile);
    addMaterial(text, materials.inside, {});
    return text;
}

}  // namespace rubble
