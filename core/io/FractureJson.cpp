#include "core/io/FractureJson.h"

#include "core/base/MessageText.h"
#include "core/fracture/Delaunay.h"
#include "core/fracture/ThesisMethod.h"
#include "core/fracture/VoronoiPartition.h"
#include "core/io/CellList.h"
#include "core/io/JsonReading.h"
#include "core/io/JsonText.h"
#include "core/io/NumberText.h"

#include <algorithm>
#include <utility>

namespace rubble {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Appends [a,b,...]: every element by `append`.
template <class Elements, class Append>
void appendArray(std::string& json, const Elements& elements, Append append) {
    json += '[';
    bool isFirst = true;
    for (const auto& element : elements) {
        if (!isFirst) json += ',';
        isFirst = false;
        append(element);
    }
    json += ']';
}

void appendPoint(std::string& json, Vec2 point) {
    json += '[';
    appendNumber(json, point.x);
    json += ',';
    appendNumber(json, point.y);
    json += ']';
}

void appendRing(std::string& json, const Ring& ring) {
    appendArray(json, ring, [&](Vec2 point) { appendPoint(json, point); });
}

template <class Indices>
void appendIndices(std::string& json, const Indices& indices) {
    appendArray(json, indices, [&](std::uint32_t index) { appendNumber(json, index); });
}

void appendCell(std::string& json, const Cell& cell) {
    json += "{\"seed\":";
    appendNumber(json, cell.seed);
    json += ",\"area\":";
    appendNumber(json, cell.area);
    json += ",\"centroid\":";
    appendPoint(json, cell.centroid);
    json += ",\"pieces\":";
    appendArray(json, cell.pieces, [&](const Polygon& piece) {
        json += "{\"outer\":";
        appendRing(json, piece.outer);
        json += ",\"holes\":";
        appendArray(json, piece.holes, [&](const Ring& hole) { appendRing(json, hole); });
        json += '}';
    });
    json += ",\"neighbours\":";
    appendIndices(json, cell.neighbours);
    json += '}';
}

void appendReport(std::string& json, const Report& report) {
    json += std::string("{\"code\":\"") + nameOf(report.code) + '"';
    const auto appendField = [&](const char* name, auto value) {
        json += std::string(",\"") + name + "\":";
        appendNumber(json, value);
    };
    if (report.seed != kNone) appendField("seed", report.seed);
    if (report.of != kNone) appendField("of", report.of);
    if (report.amount != 0.0) appendField("amount", report.amount);
    json += ",\"message\":";
    appendJsonText(json, report.message);
    json += '}';
}

std::string outputJson(std::span<const Cell> cells, const Triangles& triangles, std::span<const Report> reports) {
    std::string json = "{\"cells\":";
    appendArray(json, cells, [&](const Cell& cell) { appendCell(json, cell); });
    json += ",\"triangles\":";
    appendArray(json, triangles, [&](const auto& triangle) { appendIndices(json, triangle); });
    json += ",\"report\":";
    appendArray(json, reports, [&](const Report& report) { appendReport(json, report); });
    return json + "}\n";
}

Result<std::string> exactJson(const FractureInput& input, const TaskContext& task) {
    const Result<Delaunay> delaunay = triangulate(input.seeds, task);
    if (!delaunay) return delaunay.error();
    const Result<Partition> partition = voronoiPartition(input.prism.outline, *delaunay, task);
    if (!partition) return partition.error();
    std::vector<Report> reports = partition->reports;
    if (input.seeds.empty()) {
        const double whole = area(input.prism.outline);
        reports.push_back(
            {.code = ReportCode::Gap,
             .amount = whole,
             .message = "There are no seeds, so no cell covers the outline of " + messageText(whole) + " m^2."});
    }
    const double least = kLeastSharedEdge * boundsOf(input.prism.outline.outer).diagonal();
    return outputJson(cellList(*partition, least), triangleList(*delaunay), reports);
}

/// Triangles as triangleList() gives them.
Triangles inOrder(Triangles triangles, std::span<const Vec2> seeds) {
    for (auto& [a, b, c] : triangles) {
        if (cross(seeds[b] - seeds[a], seeds[c] - seeds[a]) < 0.0) std::swap(b, c);
    }
    for (auto& triangle : triangles) {
        std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

}  // namespace

Result<FractureInput> readFractureInput(std::string_view json) {
    Result<JsonDocument> document = JsonDocument::parse(json);
    if (!document) return document.error();
    const JsonValue root = document->root();
    root.requireObject({"outline", "depth", "seeds"}, {"holes"});
    FractureInput input;
    input.prism.outline.outer = root["outline"].points();
    if (root["holes"].isPresent()) input.prism.outline.holes = root["holes"].listOf(&JsonValue::points);
    input.prism.depth = root["depth"].number();
    input.seeds = root["seeds"].points();
    if (document->fault()) return *document->fault();
    Result<Prism> prism = validated(std::move(input.prism));
    if (!prism) return prism.error();
    input.prism = std::move(*prism);
    return input;
}

Result<std::string> fractureJson(const FractureInput& input, FractureMethod method, const TaskContext& task) {
    if (method == FractureMethod::Exact) return exactJson(input, task);
    const ThesisDiagram diagram = thesisDiagram(input.prism.outline.outer, input.seeds);
    return outputJson(cellList(diagram), inOrder(diagram.triangles, input.seeds), {});
}

}  // namespace rubble
