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

std::string paragraph(const ImportedAsset& imported, const ImportOutcome& outcome) {
    const Asset& asset = *findAsset(outcome.project, imported.asset);
    const PrismFit& prism = imported.prism;
    std::string text = quotedName(asset.name) + ", asset " + std::to_string(asset.id) +
                       (imported.isReplaced ? ", updated\n" : ", new\n");
    text += line("outline    ", outlineText(prism.outline));
    text += line("depth      ", lengthOf(prism.depth) + " along " + axisText(prism.axis) + otherAxesText(prism));
    text += line(imported.isReplaced ? "mesh at    " : "placed at  ", pointText(prism.pose.position));
    text += line(
        "tolerance  ",
        lengthOf(imported.tolerance) +
            (imported.usesFallback ? "" : ", the mesh lies within " + lengthOf(prism.deviation) + " of the prism"));
    if (prism.collinearCorners > 0)
        text += line("note       ", countText(prism.collinearCorners, "point", "points") +
                                        " on straight lines of the outline removed.");
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
