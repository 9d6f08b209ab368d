#include "core/io/exchange/UsdSurface.h"

#include "core/base/Assert.h"
#include "core/io/text/NumberText.h"

#include <map>
#include <vector>

namespace rubble {
namespace {

std::string usdInput(std::string_view type, std::string_view name) {
    return std::string(type).append(" inputs:").append(name);
}

std::string scaleText(const Colour& colour) {
    std::string text = "(";
    const Vec3 linear = linearColour(colour);
    for (int part = 0; part < 3; ++part) {
        appendFloat(text, linear[part]);
        text += ", ";
    }
    return text + "1)";
}

void beginImage(UsdWriter& usd, const std::string& path, std::string_view name, const std::string& file) {
    usd.begin("Shader", name);
    usd.setText("uniform token info:id", "UsdUVTexture");
    usd.setAsset(usdInput("asset", "file"), file);
    usd.setTarget("float2 inputs:st.connect", path + "/Coordinates.outputs:result");
    usd.setText(usdInput("token", "wrapS"), "repeat");
    usd.setText(usdInput("token", "wrapT"), "repeat");
}

void writeCoordinates(UsdWriter& usd) {
    usd.begin("Shader", "Coordinates");
    usd.setText("uniform token info:id", "UsdPrimvarReader_float2");
    usd.setText(usdInput("string", "varname"), "st");
    usd.addOutput("float2 outputs:result");
    usd.end();
}

void writeImage(UsdWriter& usd, const std::string& path, const MeshMaterial& material, const std::string& imageFile) {
    beginImage(usd, path, "Image", imageFile);
    usd.setWord(usdInput("float4", "scale"), scaleText(material.colour));
    usd.addOutput("float3 outputs:rgb");
    usd.end();
    writeCoordinates(usd);
}

void writeBakedSurface(UsdWriter& usd, const std::string& path) {
    usd.setTarget("color3f inputs:diffuseColor.connect", path + "/Colour.outputs:rgb");
    usd.setTarget("float inputs:metallic.connect", path + "/RoughnessMetalness.outputs:b");
    usd.setTarget("normal3f inputs:normal.connect", path + "/Normal.outputs:rgb");
    usd.setTarget("float inputs:roughness.connect", path + "/RoughnessMetalness.outputs:g");
}

/// Normals of 8 bits become [-1, 1] by scale and bias.
/// Source: Pixar, "UsdPreviewSurface specification", 2.6: "Texture reader".
void writeBakedImages(UsdWriter& usd, const std::string& path, const BakedImages& baked) {
    beginImage(usd, path, "Colour", baked.colour.name);
    usd.setText(usdInput("token", "sourceColorSpace"), "sRGB");
    usd.addOutput("float3 outputs:rgb");
    usd.end();
    beginImage(usd, path, "Normal", baked.normal.name);
    usd.setText(usdInput("token", "sourceColorSpace"), "raw");
    usd.setWord(usdInput("float4", "scale"), "(2, 2, 2, 1)");
    usd.setWord(usdInput("float4", "bias"), "(-1, -1, -1, 0)");
    usd.addOutput("float3 outputs:rgb");
    usd.end();
    beginImage(usd, path, "RoughnessMetalness", baked.surface.name);
    usd.setText(usdInput("token", "sourceColorSpace"), "raw");
    usd.addOutput("float outputs:g");
    usd.addOutput("float outputs:b");
    usd.end();
    writeCoordinates(usd);
}

void writePlainSurface(UsdWriter& usd, const std::string& path, const MeshMaterial& material) {
    if (material.isTextured)
        usd.setTarget("color3f inputs:diffuseColor.connect", path + "/Image.outputs:rgb");
    else
        usd.setFloats(usdInput("color3f", "diffuseColor"), linearColour(material.colour));
    if (material.opacity < 1.0) usd.setFloat(usdInput("float", "opacity"), material.opacity);
    usd.setFloat(usdInput("float", "roughness"), material.roughness());
}

void writeSubsets(UsdWriter& usd, const std::map<std::size_t, std::vector<std::uint32_t>>& faces,
                  std::span<const std::string> surfaces) {
    usd.setText("uniform token subsetFamily:materialBind:familyType", "partition");
    UsdNames names;
    for (const auto& [surface, indices] : faces) {
        const std::string& path = surfaces[surface];
        usd.begin("GeomSubset", names.unique(path.substr(path.rfind('/') + 1)), {"MaterialBindingAPI"});
        usd.setText("uniform token elementType", "face");
        usd.setText("uniform token familyName", "materialBind");
        usd.setIndices("int[] indices", indices);
        usd.setTarget("rel material:binding", path);
        usd.end();
    }
}

}  // namespace

std::string writeUsdMaterial(UsdWriter& usd, UsdNames& names, const MeshMaterial& material,
                             const std::string& imageFile, const BakedImages* baked) {
    const std::string path = usd.begin("Material", names.unique(material.name));
    usd.setTarget("token outputs:surface.connect", path + "/Surface.outputs:surface");
    usd.begin("Shader", "Surface");
    usd.setText("uniform token info:id", "UsdPreviewSurface");
    baked != nullptr ? writeBakedSurface(usd, path) : writePlainSurface(usd, path, material);
    usd.addOutput("token outputs:surface");
    usd.end();
    if (baked != nullptr) writeBakedImages(usd, path, *baked);
    if (baked == nullptr && material.isTextured) writeImage(usd, path, material, imageFile);
    usd.end();
    return path;
}

void writeUsdFaces(UsdWriter& usd, std::span<const std::uint32_t> counts, std::span<const std::uint32_t> indices,
                   std::span<const Vec3> points) {
    RUBBLE_ASSERT(!points.empty());
    Vec3 extent[2] = {points[0], points[0]};
    for (const Vec3& point : points) {
        extent[0] = glm::min(extent[0], point);
        extent[1] = glm::max(extent[1], point);
    }
    usd.setPoints("float3[] extent", extent);
    usd.setIndices("int[] faceVertexCounts", counts);
    usd.setIndices("int[] faceVertexIndices", indices);
    usd.setText("uniform token orientation", "rightHanded");
    usd.setPoints("point3f[] points", points);
    usd.setText("uniform token subdivisionScheme", "none");
}

void writeUsdMesh(UsdWriter& usd, std::string_view name, const Mesh& mesh, std::span<const std::string> surfaces) {
    std::vector<std::uint32_t> counts, indices, normals, uvs;
    std::map<std::size_t, std::vector<std::uint32_t>> faces;  // by surface
    for (std::uint32_t k = 0; k < mesh.faces.size(); ++k) {
        const MeshFace& face = mesh.faces[k];
        counts.push_back(face.cornerCount);
        faces[face.side == FaceSide::Inside ? surfaces.size() - 1 : face.material].push_back(k);
        for (const MeshCorner& corner : mesh.cornersOf(face)) {
            indices.push_back(corner.position);
            normals.push_back(face.normal);
            uvs.push_back(corner.uv);
        }
    }
    usd.begin("Mesh", name, {"MaterialBindingAPI"});
    writeUsdFaces(usd, counts, indices, mesh.positions);
    usd.setPoints("normal3f[] primvars:normals", mesh.normals, UsdInterpolation::FaceVarying);
    usd.setIndices("int[] primvars:normals:indices", normals);
    usd.setPoints("texCoord2f[] primvars:st", mesh.uvs, UsdInterpolation::FaceVarying);
    usd.setIndices("int[] primvars:st:indices", uvs);
    usd.setTarget("rel material:binding", surfaces[faces.begin()->first]);
    if (faces.size() > 1) writeSubsets(usd, faces, surfaces);
    usd.end();
}

}  // namespace rubble
