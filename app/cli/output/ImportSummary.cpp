#include "app/cli/output/ImportSummary.h"

#include "core/base/MessageText.h"
#include "core/base/QuantityText.h"

namespace rubble {
namespace {

std::string lengthOf(double metres) { return quantityText(QuantityKind::Length, metres); }

std::string outlineText(const Polygon& outline) {
    const Vec2 size = boundsOf(outline.outer).size();
    std::string text = countText(outline.outer.size(), "corner", "corners");
    if (!outline.holes.empty()) text += ", " + countText(outline.holes.size(), "hole", "holes");
    return text + ", " + lengthOf(size.x) + " × " + lengthOf(size.y);
}

std::string otherAxesText(const PrismFit& prism) {
    std::string text;
    for (const Vec3 axis : prism.otherAxes) text += (text.empty() ? "" : " and ") + axisText(axis);
    return text.empty() ? "" : " (it is a prism along " + text + " too)";
}

std::string pointText(Vec3 point) {
    return "(" + roundedNumber(point.x) + ", " + roundedNumber(point.y) + ", " + roundedNumber(point.z) + ")";
}

std::string line(const char* label, const std::string& text) { return std::string("  ") + label + text + "\n"; }

std::string sizeText(Vec3 size) { return lengthOf(size.x) + " × " + lengthOf(size.y) + " × " + lengthOf(size.z); }

std::string prismLines(const ImportedAsset& imported) {
    const PrismFit& prism = *imported.prism;
    std::string text = line("outline    ", outlineText(prism.outline));
    text += line("depth      ", lengthOf(prism.depth) + " along " + axisText(prism.axis) + otherAxesText(prism));
    text += line(imported.isReplaced ? "mesh at    " : "placed at  ", pointText(prism.pose.position));
    text += line(
        "tolerance  ",
        lengthOf(imported.tolerance) +
            (imported.usesFallback ? "" : ", the mesh lies within " + lengthOf(prism.deviation) + " of the prism"));
    if (prism.collinearCorners > 0)
        text += line("note       ", countText(prism.collinearCorners, "point", "points") +
                                        " on straight lines of the outline removed.");
    return text;
}

std::string solidLines(const ImportedAsset& imported) {
    const SolidFit& solid = *imported.solid;
    std::string what = countText(solid.mesh->mesh.triangles.size(), "triangle", "triangles") + ", " +
                       quantityText(QuantityKind::Volume, solid.mesh->mass.volume) + ", " +
                       countText(solid.parts, "part", "parts");
    if (solid.cavities > 0) what += ", " + countText(solid.cavities, "cavity", "cavities");
    std::string text = line("solid      ", what);
    text += line("size       ", sizeText(solid.mesh->bounds.max - solid.mesh->bounds.min));
    text += line(imported.isReplaced ? "mesh at    " : "placed at  ", pointText(solid.position));
    if (!solid.whyNoPrism.empty()) text += line("no prism   ", solid.whyNoPrism);
    return text;
}

std::string paragraph(const ImportedAsset& imported, const ImportOutcome& outcome) {
    const Asset& asset = *findAsset(outcome.project, imported.asset);
    std::string text = quotedName(asset.name) + ", asset " + std::to_string(asset.id) +
                       (imported.isReplaced ? ", updated\n" : ", new\n");
    text += imported.solid ? solidLines(imported) : prismLines(imported);
    for (const std::string& note : imported.notes) text += line("note       ", note);
    return text;
}

}  // namespace

std::string importSummary(const ImportOutcome& outcome, const std::string& projectPath) {
    std::string text;
    for (const ImportedAsset& imported : outcome.assets) text += paragraph(imported, outcome);
    return text + "One unit of the file is " + lengthOf(outcome.metresPerUnit) + ". Saved " + projectPath + "\n";
}

}  // namespace rubble
