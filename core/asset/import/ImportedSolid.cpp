#include "core/asset/import/ImportedSolid.h"

#include "core/asset/project/Ranges.h"
#include "core/base/MessageText.h"
#include "core/base/QuantityText.h"
#include "core/geometry/mesh/MeshWelding.h"
#include "core/geometry/mesh/SolidMesh.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace rubble {
namespace {

std::vector<std::string> weldingNotes(const WeldedMesh& welded) {
    std::vector<std::string> notes;
    if (welded.mergedPoints > 0)
        notes.push_back(countText(welded.mergedPoints, "point was", "points were") + " merged with others up to " +
                        lengthText(welded.maxMergeDistance) + " away.");
    if (welded.droppedTriangles > 0)
        notes.push_back(countText(welded.droppedTriangles, "triangle", "triangles") + " of zero area omitted.");
    return notes;
}

/// The triangles of a mesh that belong to one part.
ImportPart partOf(const ImportPart& whole, const std::vector<std::uint32_t>& parts, std::uint32_t number) {
    ImportPart part{.name = whole.name,
                    .hasUvs = whole.hasUvs,
                    .tolerance = whole.tolerance,
                    .rounding = whole.rounding,
                    .copies = whole.copies,
                    .notes = whole.notes};
    std::vector<std::uint32_t> indices(whole.mesh.points.size(), kNone);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i] != number) continue;
        part.triangles.push_back(whole.triangles[i]);
        auto triangle = whole.mesh.triangles[i];
        for (std::uint32_t& corner : triangle) {
            std::uint32_t& index = indices[corner];
            if (index == kNone) {
                index = static_cast<std::uint32_t>(part.mesh.points.size());
                part.mesh.points.push_back(whole.mesh.points[corner]);
            }
            corner = index;
        }
        part.mesh.triangles.push_back(triangle);
    }
    return part;
}

Vec3 uprightOf(Vec3 point, UpAxis up) { return up == UpAxis::Z ? Vec3(point.x, point.z, -point.y) : point; }

/// Motions of the file's scene, in the world.
std::vector<Pose> copiesInWorld(const SourceObject& object, double metresPerUnit, UpAxis up) {
    std::vector<Pose> copies;
    for (const Pose& copy : object.copies) {
        const Quat& turn = copy.orientation;
        const Vec3 axis = uprightOf({turn.x, turn.y, turn.z}, up);
        copies.push_back({metresPerUnit * uprightOf(copy.position, up), Quat(turn.w, axis.x, axis.y, axis.z)});
    }
    return copies;
}

/// An error if a mesh lies where positions of a project end, or where single precision, which most files have, has lost
/// its shape.
std::optional<Error> farFault(const TriangleMesh& mesh) {
    constexpr double kMaxLost = 0.01;  // of the diagonal
    if (mesh.points.empty()) return std::nullopt;
    const Box3 box = boundsOf(mesh);
    const Vec3 centre = (box.min + box.max) / 2.0;
    const double limit = rangeOf(ProjectNumber::InstancePosition).max;
    const double farthest = std::max({std::abs(centre.x), std::abs(centre.y), std::abs(centre.z)});
    const bool isBeyond = farthest > limit && box.diagonal() < farthest;
    const bool isLost = 0x1p-22 * farthest > kMaxLost * box.diagonal() && box.diagonal() > 0.0;
    if (!std::isfinite(farthest) || farthest >= kMaxMeshCoordinate || (!isBeyond && !isLost)) return std::nullopt;
    const std::string place =
        "(" + roundedNumber(centre.x) + ", " + roundedNumber(centre.y) + ", " + roundedNumber(centre.z) + ") m";
    const std::string why = isBeyond
                                ? "positions go up to " + lengthText(limit)
                                : "its size of " + lengthText(box.diagonal()) + " is lost in single precision there";
    // A smaller unit helps only where the mesh is too large, too.
    constexpr double kLargest = 200.0;
    const bool isWrongUnit = isBeyond && box.diagonal() > kLargest;
    return Error{ErrorCode::BadInput, "The mesh lies far away from the origin, at " + place + ", and " + why + "; " +
                                          (isWrongUnit ? "set its unit, or " : "") +
                                          "move it to the origin in the program that made it."};
}

bool liesWithin(const Box3& inner, const Box3& outer) {
    return glm::all(glm::greaterThanEqual(inner.min, outer.min)) && glm::all(glm::lessThanEqual(inner.max, outer.max));
}

/// The parts of an object that has several; `numbers`: each triangle's. Errors: Limit; Degenerate: one is the wall of a
/// cavity.
Result<std::vector<ImportPart>> splitParts(ImportPart whole, const std::vector<std::uint32_t>& numbers,
                                           std::uint32_t count) {
    constexpr std::uint32_t kMaxParts = 1000;
    if (count > kMaxParts)
        return Error{ErrorCode::Limit, "It has " + std::to_string(count) + " unconnected parts, but at most " +
                                           std::to_string(kMaxParts) + " can be imported."};
    const std::vector<std::uint32_t> connected = connectedParts(whole.mesh);
    const bool areTouching = *std::ranges::max_element(connected) + 1 < count;
    whole.notes.push_back("The object has " + std::to_string(count) +
                          (areTouching ? " parts, some of which only touch," : " unconnected parts,") +
                          " imported one by one.");
    std::vector<ImportPart> parts;
    for (std::uint32_t number = 0; number < count; ++number) parts.push_back(partOf(whole, numbers, number));
    std::vector<Box3> inverted, upright;
    for (const ImportPart& part : parts) {
        const double volume = signedVolume(part.mesh);
        if (volume < 0.0) inverted.push_back(boundsOf(part.mesh));
        if (volume > 0.0) upright.push_back(boundsOf(part.mesh));
    }
    for (const Box3& inner : inverted) {
        if (std::ranges::any_of(upright, [&](const Box3& around) { return liesWithin(inner, around); }))
            return Error{ErrorCode::Degenerate, "The mesh has a cavity: one of its " + std::to_string(count) +
                                                    " parts is inverted and lies within another."};
    }
    return parts;
}

/// An object that is imported as it is.
ImportPart wholeObject(const SourceObject& object, TriangleMesh mesh, double metresPerUnit, UpAxis up) {
    ImportPart whole{.name = object.name, .hasUvs = object.hasUvs, .tolerance = meshTolerance(mesh)};
    whole.mesh = mesh;
    whole.triangles = object.triangles;
    whole.copies = copiesInWorld(object, metresPerUnit, up);
    whole.unwelded = std::move(mesh);
    return whole;
}

/// The mesh's triangles in the prism's frame.
std::vector<SurfaceTriangle> surfaceTriangles(const ImportPart& part, const std::vector<std::uint32_t>& flipped,
                                              const Pose& pose) {
    const Quat localFromWorld = glm::conjugate(pose.orientation);
    std::vector<SurfaceTriangle> triangles;
    for (std::size_t i = 0; i < part.triangles.size(); ++i) {
        SurfaceTriangle& triangle = triangles.emplace_back();
        triangle.uvs = part.triangles[i].uvs;
        triangle.material = part.triangles[i].material;
        for (int k = 0; k < 3; ++k)
            triangle.corners[k] = localFromWorld * (part.mesh.points[part.mesh.triangles[i][k]] - pose.position);
        if (std::ranges::binary_search(flipped, static_cast<std::uint32_t>(i))) {
            std::swap(triangle.corners[1], triangle.corners[2]);
            std::swap(triangle.uvs[1], triangle.uvs[2]);
        }
    }
    return triangles;
}

std::uint32_t largestMaterial(const ImportPart& part) {
    std::map<std::uint32_t, double> areas;
    for (std::size_t i = 0; i < part.triangles.size(); ++i)
        areas[part.triangles[i].material] += glm::length(doubleArea(part.mesh, i));
    return std::ranges::max_element(areas, {}, [](const auto& area) { return area.second; })->first;
}

/// The materials of the file that the part uses, in its order: those of its surface.
std::vector<std::uint32_t> usedMaterials(const ImportPart& part) {
    std::vector<std::uint32_t> used;
    for (const SourceTriangle& triangle : part.triangles) used.push_back(triangle.material);
    std::ranges::sort(used);
    used.erase(std::ranges::unique(used).begin(), used.end());
    return used;
}

/// The area, twice, that each image of the scene covers.
std::map<std::uint32_t, double> imageAreas(const ImportPart& part, const SourceScene& scene) {
    std::map<std::uint32_t, double> areas;
    for (std::size_t i = 0; i < part.triangles.size(); ++i)
        if (const auto image = scene.materials[part.triangles[i].material].image)
            areas[*image] += glm::length(doubleArea(part.mesh, i));
    return areas;
}

/// The image with the largest area as a texture; none without texture coordinates.
std::optional<Texture> textureOf(const ImportPart& part, const SourceScene& scene, TextureImages& images,
                                 std::vector<std::string>& notes) {
    const std::map<std::uint32_t, double> areas = imageAreas(part, scene);
    if (areas.empty()) return std::nullopt;
    const std::uint32_t index =
        std::ranges::max_element(areas, {}, [](const auto& area) { return area.second; })->first;
    const SourceImage& source = scene.images[index];
    if (!part.hasUvs) {
        notes.push_back("The image " + quotedName(source.name) +
                        " is not imported: the mesh has no texture coordinates.");
        return std::nullopt;
    }
    std::shared_ptr<const EncodedImage>& image = images[index];
    if (!image) image = std::make_shared<const EncodedImage>(source.image);
    Texture texture{.name = source.name, .image = image, .materials = {}};
    const std::vector<std::uint32_t> used = usedMaterials(part);
    for (std::uint32_t k = 0; k < used.size(); ++k)
        if (scene.materials[used[k]].image == index) texture.materials.push_back(k);
    const std::string name = quotedName(source.name) + " (" + source.image.sizeText() + ")";
    notes.push_back(areas.size() == 1 ? "It has the base-colour texture " + name + "."
                                      : "It has " + std::to_string(areas.size()) + " images; " + name +
                                            ", which covers the largest area, is its base-colour texture.");
    return texture;
}

void noteCap(const CapFit& fit, const CapUv& cap, const char* name, std::vector<std::string>& notes) {
    if (cap.isAffine) return;
    std::string why = ": no face of the mesh lies on it.";
    if (fit.materials > 1) {
        why = ": it has " + std::to_string(fit.materials) + " materials; the one with the largest area is used.";
    } else if (fit.deviation) {
        why =
            ": its own are not planar (they deviate by " + roundedText(*fit.deviation, 2) + " of the texture's size).";
    } else if (fit.triangles > 0) {
        why = ": its faces have no area.";
    }
    notes.push_back(std::string("The ") + name + " cap takes its UVs from the nearest faces" + why);
}

/// The prism of a part that is one but for the rounding of its file. If that is too coarse for the size of the part, or
/// does not explain why it is not a prism, the reason, with advice in the first case.
Result<PrismFit> prismOfRounded(const ImportPart& part, const TriangleMesh& solid, PrismAxis axis, Error reason,
                                ImportedSolid& result) {
    // Of the smallest extent. Up to the first, the depth of a prism is right within some thousandths; beyond the
    // second, nearly any shape is a prism.
    constexpr double kMaxFitted = 0.01, kMaxExplained = 0.1;
    if (!(part.rounding > 0.0) || part.rounding > kMaxExplained * boundsOf(solid).diagonal()) return reason;
    const std::optional<PrismFit> prism = fitRoundedPrism(solid, axis, part.tolerance, part.rounding);
    if (!prism || part.rounding > kMaxExplained * smallestExtent(*prism)) return reason;
    const std::string clause = "file rounds points by up to " + lengthText(part.rounding);
    if (part.rounding > kMaxFitted * smallestExtent(*prism)) {
        if (reason.message.ends_with('.')) reason.message.pop_back();
        reason.message +=
            "; the " + clause +
            ", too much to tell whether it is a prism: export it with more decimals or finer quantization.";
        return reason;
    }
    result.tolerance = std::max(part.tolerance, part.rounding);
    result.notes.push_back("The " + clause + "; the prism is fitted to them within " + lengthText(prism->deviation) +
                           ".");
    return *prism;
}

/// The fitted prism, or its fallback.
Result<PrismFit> prismOf(const ImportPart& part, const Result<SolidMesh>& solid, const ImportOptions& options,
                         ImportedSolid& result) {
    if (part.noPrism) return *part.noPrism;
    if (isFlat(part)) return Error{ErrorCode::Degenerate, "The mesh is flat; an asset needs a depth."};
    result.tolerance = part.tolerance;
    Result<PrismFit> found = solid ? fitPrism(solid->mesh, options.axis, part.tolerance) : solid.error();
    if (!found && solid) found = prismOfRounded(part, solid->mesh, options.axis, found.error(), result);
    if (found || !options.fallback) return found;
    const std::string why = found.error().message;
    found = fallbackPrism(part.mesh, options.axis, *options.fallback, part.tolerance);
    const char* what = *options.fallback == PrismFallback::Silhouette ? "silhouette" : "top cap";
    if (!found)
        return Error{found.error().code,
                     "Its " + std::string(what) + " cannot be used instead: " + found.error().message};
    result.usesFallback = true;
    std::string note = "The " + std::string(what) + " along " + axisText(found->axis) + " is used instead. " + why;
    const std::string before = solid ? quantityText(QuantityKind::Volume, solid->volume) : "";
    const std::string after = quantityText(QuantityKind::Volume, volumeOf(*found));
    if (solid && before != after) note += " The volume changes from " + before + " to " + after + ".";
    result.notes.push_back(note);
    return found;
}

/// The part as a prism or as its fallback.
Result<ImportedSolid> importedPrism(const ImportPart& part, const SourceScene& scene, const ImportOptions& options,
                                    TextureImages& images) {
    ImportedSolid result{.notes = part.notes};
    const Result<SolidMesh> solid = orientedSolid(part.mesh, part.tolerance);
    Result<PrismFit> found = prismOf(part, solid, options, result);
    if (!found) return found.error();
    result.prism = std::move(*found);
    const std::vector<std::uint32_t> flipped = solid ? solid->flipped : std::vector<std::uint32_t>{};
    if (!flipped.empty())
        result.notes.push_back("The orientation of " +
                               countText(flipped.size(), "inverted triangle was", "inverted triangles were") +
                               " corrected.");
    std::vector<std::string> materials;
    for (const SourceMaterial& material : scene.materials) materials.push_back(material.name);
    result.surface = fittedSurface(surfaceTriangles(part, flipped, result.prism->pose), part.hasUvs, materials,
                                   {result.prism->outline, result.prism->depth}, 4.0 * result.tolerance);
    result.material = largestMaterial(part);
    result.texture = textureOf(part, scene, images, result.notes);
    if (result.surface.surface && part.hasUvs) {
        noteCap(result.surface.front, result.surface.surface->front, "front", result.notes);
        noteCap(result.surface.back, result.surface.surface->back, "back", result.notes);
    }
    return result;
}

/// Notes the images that a closed mesh does not keep.
void noteLostTexture(const ImportPart& part, const SourceScene& scene, std::vector<std::string>& notes) {
    const std::map<std::uint32_t, double> areas = imageAreas(part, scene);
    if (areas.empty()) return;
    const std::string what =
        areas.size() == 1 ? "The texture " + quotedName(scene.images[areas.begin()->first].name) + " is not imported"
                          : "Its " + std::to_string(areas.size()) + " textures are not imported";
    notes.push_back(what + ": only prisms keep textures.");
}

/// Makes "The mesh is bent." the end of a sentence.
std::string asClause(std::string sentence) {
    if (sentence.starts_with("The ")) sentence[0] = 't';
    return sentence;
}

/// The part as a closed mesh. `noPrism`: why it is not a prism, if it might have been one.
PartOutcome closedSolid(const ImportPart& part, const SourceScene& scene, const std::optional<Error>& noPrism,
                        const TaskContext& context) {
    const bool isWhole = !part.unwelded.triangles.empty();
    Result<SolidTrial> trial = fittedSolid(isWhole ? part.unwelded : part.mesh, context);
    if (!trial) return {trial.error(), std::nullopt};
    if (trial->problem) {
        std::string message = "It cannot be cut: " + trial->problem->message;
        const bool isClosed = noPrism && (part.noPrism || orientedSolid(part.mesh, part.tolerance).hasValue());
        if (isClosed) {
            message.pop_back();
            message += "; it is not a prism either: " + asClause(noPrism->message);
        }
        return {Error{ErrorCode::Degenerate, message}, std::move(trial->problem)};
    }
    ImportedSolid result;
    // What was welded concerns the parts of a mesh that had to be split.
    if (!isWhole) result.notes = part.notes;
    result.notes.insert(result.notes.end(), trial->notes.begin(), trial->notes.end());
    result.closed = std::move(trial->solid);
    if (noPrism) result.closed->whyNoPrism = noPrism->message;
    result.tolerance = part.tolerance;
    result.material = largestMaterial(part);
    noteLostTexture(part, scene, result.notes);
    return {std::move(result), std::nullopt};
}

}  // namespace

TriangleMesh meshInWorld(const SourceObject& object, double metresPerUnit, UpAxis up) {
    TriangleMesh mesh;
    for (const Vec3 point : object.points) {
        mesh.points.push_back(metresPerUnit * uprightOf(point, up));
    }
    for (const SourceTriangle& triangle : object.triangles) mesh.triangles.push_back(triangle.points);
    return mesh;
}

Result<std::vector<ImportPart>> partsToImport(const SourceObject& object, double metresPerUnit, UpAxis up,
                                              ImportShape as) {
    TriangleMesh mesh = meshInWorld(object, metresPerUnit, up);
    if (std::optional<Error> fault = farFault(mesh)) return *fault;
    if (as == ImportShape::Solid) return std::vector{wholeObject(object, std::move(mesh), metresPerUnit, up)};
    Result<WeldedMesh> one = welded(mesh);
    if (!one) return one.error();
    ImportPart whole{.name = object.name, .hasUvs = object.hasUvs, .tolerance = one->tolerance};
    whole.rounding = object.rounding * metresPerUnit;
    whole.copies = copiesInWorld(object, metresPerUnit, up);
    whole.notes = weldingNotes(*one);
    whole.mesh = std::move(one->mesh);
    for (const std::uint32_t source : one->sources) whole.triangles.push_back(object.triangles[source]);
    const std::vector<std::uint32_t> numbers = solidParts(whole.mesh);
    const std::uint32_t count = 1 + *std::ranges::max_element(numbers);
    if (count == 1) {
        whole.unwelded = std::move(mesh);
        return std::vector{std::move(whole)};
    }
    Result<std::vector<ImportPart>> parts = splitParts(std::move(whole), numbers, count);
    if (parts || parts.error().code != ErrorCode::Degenerate || as == ImportShape::Prism) return parts;
    ImportPart hollow = wholeObject(object, std::move(mesh), metresPerUnit, up);
    hollow.noPrism = parts.error();
    return std::vector{std::move(hollow)};
}

bool isFlat(const ImportPart& part) {
    const TriangleMesh& mesh = part.mesh;
    std::size_t largest = 0;
    for (std::size_t i = 1; i < mesh.triangles.size(); ++i)
        if (glm::length(doubleArea(mesh, i)) > glm::length(doubleArea(mesh, largest))) largest = i;
    const Vec3 normal = glm::normalize(doubleArea(mesh, largest)), origin = mesh.points[mesh.triangles[largest][0]];
    return std::ranges::all_of(
        mesh.points, [&](Vec3 point) { return std::abs(glm::dot(point - origin, normal)) <= part.tolerance; });
}

std::variant<Prism, std::shared_ptr<const ClosedMesh>> ImportedSolid::shape() const {
    if (closed) return closed->mesh;
    return Prism{prism->outline, prism->depth};
}

PartOutcome importedSolid(const ImportPart& part, const SourceScene& scene, const ImportOptions& options,
                          TextureImages& images, const TaskContext& context) {
    if (options.as == ImportShape::Solid) return closedSolid(part, scene, std::nullopt, context);
    PartOutcome prism{importedPrism(part, scene, options, images), std::nullopt};
    if (prism.solid || options.as == ImportShape::Prism) return prism;
    const bool hasFallback = options.fallback && !part.noPrism;
    if (hasFallback || isFlat(part)) return prism;
    return closedSolid(part, scene, prism.solid.error(), context);
}

}  // namespace rubble
