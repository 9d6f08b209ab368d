#include "core/io/formats/ExportFormat.h"
#include "core/io/system/FileName.h"
#include "core/io/text/CsvTable.h"

namespace rubble {
namespace {

/// docs/formats/csv.md describes the columns.
std::span<const std::string> massColumns() {
    static const std::vector<std::string> columns{"id",     "name",      "parent",    "level",     "mass",
                                                  "volume", "centre[0]", "centre[1]", "centre[2]", "threshold"};
    return columns;
}

void addBody(CsvTable& table, const PackBody& body, const std::string& parent) {
    const Vec3 centre = body.offset + body.centreOfMass;
    table.openObject();
    table.text("id", body.id);
    table.text("name", body.name);
    table.text("parent", parent);
    table.wholeNumber("level", body.level);
    table.number("mass", body.mass);
    table.number("volume", body.volume);
    table.numbers("centre", {centre.x, centre.y, centre.z});
    if (body.threshold) table.number("threshold", *body.threshold);
    table.close();
}

Result<std::vector<std::string>> massTable(const FormatInput& input) {
    const PackBuilder& pack = input.pack;
    CsvTable table(massColumns());
    const PackBody whole = pack.whole();
    addBody(table, whole, {});
    for (std::uint32_t index = 0; index < pack.fragmentCount(); ++index) {
        if (input.task.isCancelled()) return TaskContext::cancelled();
        const PackBody body = pack.fragment(index);
        addBody(table, body, body.parent == kNone ? whole.id : pack.input().bake.fragmentId(body.parent));
    }
    return std::vector{std::move(table).finished()};
}

}  // namespace

extern const ExportFormat kCsvFormat;
constinit const ExportFormat kCsvFormat{
    .word = "csv",
    .caption = "CS&V",
    .hint = "Write a table of the fragments with their masses and places",
    .bytesPerFragment = [](const MeshOptions&) { return 400.0; },
    .assetFileNames = [](const PackNames& names) { return std::vector{fittingFileName("", names.folder, ".csv")}; },
    .assetFiles = massTable};

}  // namespace rubble
