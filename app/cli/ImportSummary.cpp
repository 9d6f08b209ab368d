#include "app/cli/ImportSummary.h"

#include "core/base/MessageText.h"

namespace rubble {
namespace {

std::string counted(std::size_t count, const char* one, const char* many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string outlineText(const Polygon& outline) {
    const Vec2 size = boundsOf(outline.outer).size();
    std::string text = counted(outline.outer.size(), "corner", "corners");
    if (!outline.holes.empty()) text += ", " + counted(outline.holes.size(), "hole", "holes");
    return text + ", " + lengthText(size.x) + " x " + lengthText(size.y);
}

std::string otherAxesText(const FoundPrism& prism) {
    std::string text;
    for (const Vec3 axis : prism.otherAxes) text += (text.empty() ? "" : " and ") + axisText(axis);
    return text.empty() ? "" : " (it is a prism along " + text + " too)";
}

std::string pointText(Vec3 point) {
    return "(" + messageText(point.x) + ", " + messageText(point.y) + ", " + messageText(point.z) + ")";
}

std::string line(const char* label, const std::string& text) { return std::string("  ") + label + text + "\n"; }

std::string paragraph(const ImportedAsset& imported, const ImportOutcome& outcome) {
    const Asset& asset = *findAsset(outcome.project, imported.asset);
    const FoundPrism& prism = imported.prism;
    std::string text = "\"" + asset.name + "\", asset " + std::to_string(asset.id) +
                       (imported.isReplaced ? ", imported again\n" : ", new\n");
    text += line("outline    ", outlineText(prism.outline));
    text += line("depth      ", lengthText(prism.depth) + " along " + axisText(prism.axis) + otherAxesText(prism));
    text += line(imported.isReplaced ? "mesh at    " : "placed at  ", pointText(prism.pose.position));
    text +=
        line("tolerance  ",
             lengthText(imported.tolerance) +
                 (imported.isStandIn ? "" : ", the mesh lies within " + lengthText(prism.deviation) + " of the prism"));
    if (prism.straightCorners > 0)
        text += line("note       ",
                     counted(prism.straightCorners, "point", "points") + " on straight lines of the outline left out.");
    for (const std::string& note : imported.notes) text += line("note       ", note);
    return text;
}

}  // namespace

std::string importSummary(const ImportOutcome& outcome, const std::string& projectPath) {
    std::string text;
    for (const ImportedAsset& imported : outcome.assets) text += paragraph(imported, outcome);
    return text + "One unit of the file is " + lengthText(outcome.metresPerUnit) + ". Written: " + projectPath + "\n";
}

}  // namespace rubble
