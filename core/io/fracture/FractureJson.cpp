#include "core/io/fracture/FractureJson.h"

#include "core/base/MessageText.h"
#include "core/base/QuantityText.h"
#include "core/fracture/delaunay/Delaunay.h"
#include "core/fracture/voronoi/VoronoiPartition.h"
#include "core/geometry/polygon/OutlineCleaning.h"
#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"

#include <algorithm>
#include <utility>

namespace rubble {
namespace {

void writeCell(JsonWriter& json, const Cell& cell) {
    json.openObject();
    json.wholeNumber("seed", std::uint64_t{cell.seed});
    json.number("area", cell.area);
    json.numbers("centroid", {cell.centroid.x, cell.centroid.y});
    json.openArray("pieces");
    for (const Polygon& piece : cell.pieces) {
        json.openObject();
        json.points("outer", piece.outer);
        json.openArray("holes");
        for (const Ring& hole : piece.holes) json.points({}, hole);
        json.close();
        json.close();
    }
    json.close();
    json.wholeNumbers("neighbours", cell.neighbours);
    json.close();
}

/// Removes the repeated points of a ring and reports them.
void cleanRing(Ring& ring, const std::string& name, std::vector<Diagnostic>& diagnostics) {
    const Ring given = ring;
    for (const std::size_t i : removeRepeatedPoints(ring)) {
        const Vec2 point = given[i];
        const char* equal = i > 0 && point == given[i - 1] ? "the point before it" : "its first point";
        diagnostics.push_back(
            diagnostic(DiagnosticCode::RepeatedPoint, {.point = DiagnosticPlace::Point{point.x, point.y}},
                       "Point " + std::to_string(i) + " of " + name + " repeats " + equal + ", at (" +
                           messageText(point.x) + ", " + messageText(point.y) + "), and was left out."));
    }
}

}  // namespace

void writeFractureReport(JsonWriter& json, const Diagnostic& report) {
    json.openObject();
    json.text("code", nameOf(report.code));
    if (report.place.seed != kNone) json.wholeNumber("seed", std::uint64_t{report.place.seed});
    if (report.place.otherSeed != kNone) json.wholeNumber("of", std::uint64_t{report.place.otherSeed});
    if (report.value != 0.0) json.number("amount", report.value);
    json.text("message", report.message);
    json.close();
}

Result<FractureInput> readFractureInput(std::string_view json) {
    Result<JsonDocument> document = JsonDocument::parse(json);
    if (!document) return document.error();
    const JsonValue root = document->root();
    root.requireObject({"outline", "depth", "seeds"}, {"holes"});
    FractureInput input;
    input.prism.outline.outer = root["outline"].points();
    if (root["holes"].isPresent()) input.prism.outline.holes = root["holes"].list(&JsonValue::points);
    input.prism.depth = root["depth"].number();
    input.seeds = root["seeds"].points();
    if (document->firstError()) return *document->firstError();
    Polygon& outline = input.prism.outline;
    cleanRing(outline.outer, "the outline", input.diagnostics);
    for (std::size_t i = 0; i < outline.holes.size(); ++i)
        cleanRing(outline.holes[i], "hole " + std::to_string(i), input.diagnostics);
    Result<Prism> prism = validated(std::move(input.prism));
    if (!prism) {
        Error error = prism.error();
        if (!input.diagnostics.empty()) error.message += " Points are counted without those that repeat others.";
        return error;
    }
    input.prism = std::move(*prism);
    return input;
}

std::string cellsJson(const std::vector<Cell>& cells, const std::vector<std::array<std::uint32_t, 3>>& triangles,
                      const std::vector<Diagnostic>& reports) {
    JsonWriter json(JsonLayout::Compact);
    json.openObject();
    json.list("cells", cells, writeCell);
    json.rows("triangles", triangles, [](const auto& corners) {
        return std::array<std::int64_t, 3>{corners[0], corners[1], corners[2]};
    });
    json.list("report", reports, writeFractureReport);
    json.close();
    return std::move(json).finished();
}

Result<std::string> fractureJson(const FractureInput& input, const TaskContext& task) {
    const Result<Delaunay> delaunay = triangulate(input.seeds, task);
    if (!delaunay) return delaunay.error();
    const Result<Partition> partition = voronoiPartition(input.prism.outline, *delaunay, task);
    if (!partition) return partition.error();
    std::vector<Diagnostic> reports = input.diagnostics;
    reports.insert(reports.end(), partition->diagnostics.begin(), partition->diagnostics.end());
    if (input.seeds.empty()) {
        const double whole = area(input.prism.outline);
        reports.push_back(diagnostic(
            DiagnosticCode::Gap, {},
            "There are no seeds, so no cell covers the outline of " + quantityText(QuantityKind::Area, whole) + ".",
            whole));
    }
    const double least = kMinSharedEdge * boundsOf(input.prism.outline.outer).diagonal();
    return cellsJson(cellList(*partition, least), triangleList(*delaunay), reports);
}

}  // namespace rubble
