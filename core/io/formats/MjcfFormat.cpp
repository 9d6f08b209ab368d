#include "core/io/exchange/MjcfFile.h"

#include "core/io/formats/ExportFormat.h"
#include "core/io/system/FileName.h"

namespace rubble {
namespace {

Result<std::vector<std::string>> mjcfFiles(const FormatInput& input) {
    Result<std::string> model = mjcfFile(input.pack, unbrokenFragments(input.pack.input().bake), input.task);
    if (!model) return model.error();
    return std::vector{std::move(*model)};
}

}  // namespace

extern const ExportFormat kMjcfFormat;
constinit const ExportFormat kMjcfFormat{
    .word = "mjcf",
    .caption = "MuJo&Co",
    .hint = "Write the fragments as a model of MuJoCo (MJCF)",
    .bytesPerFragment = [](const MeshOptions&) { return 1200.0; },
    .assetFileNames =
        [](const PackNames& names) { return std::vector{fittingFileName("", names.folder, ".mjcf.xml")}; },
    .assetFiles = mjcfFiles};

}  // namespace rubble
