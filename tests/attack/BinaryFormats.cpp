#include "core/io/system/AtomicFile.h"
#include "tests/attack/Format.h"
#include "tests/attack/Mutator.h"
#include "tests/support/files/FuzzedReaders.h"
#include "tests/support/files/PngChecksums.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>

namespace rubble::attack {
namespace {

namespace fs = std::filesystem;

using Samples = std::shared_ptr<const std::vector<std::string>>;

/// The files of a format's corpus that are not findings.
Samples samplesOf(const std::string& format) {
    std::vector<std::string> samples;
    for (const auto& entry : fs::directory_iterator(RUBBLE_SOURCE_DIR "/tests/corpus/" + format)) {
        if (entry.path().filename().string().starts_with("found-")) continue;
        Result<std::string> bytes = readFile(entry.path());
        if (bytes) samples.push_back(std::move(*bytes));
    }
    if (samples.empty()) {
        std::fprintf(stderr, "There are no samples of %s.\n", format.c_str());
        std::exit(2);
    }
    std::ranges::sort(samples);
    return std::make_shared<const std::vector<std::string>>(std::move(samples));
}

std::string mutatedSample(const Samples& samples, Random& random) {
    return mutatedBytes((*samples)[random.below(samples->size())], random);
}

}  // namespace

std::vector<Format> binaryFormats() {
    std::vector<Format> formats;
    formats.push_back({.name = "Png",
                       .ending = ".png",
                       .mutated =
                           [samples = samplesOf("Png")](Random& random) {
                               const std::string bytes = mutatedSample(samples, random);
                               return random.below(8) == 0 ? bytes : test::withPngChecksums(bytes);
                           },
                       .check =
                           [](std::string_view bytes, Random&) {
                               const bool isAccepted = greyImageOfPng(bytes, "picture.png").hasValue();
                               return Verdict{.isAccepted = isAccepted, .fault = test::pngFault(bytes)};
                           },
                       .checks = 1});
    formats.push_back(
        {.name = "Radiance",
         .ending = ".hdr",
         .mutated = [samples = samplesOf("Radiance")](Random& random) { return mutatedSample(samples, random); },
         .check =
             [](std::string_view bytes, Random&) {
                 const bool isAccepted = radianceOfFile(bytes, "sky.hdr").hasValue();
                 return Verdict{.isAccepted = isAccepted, .fault = test::radianceFault(bytes)};
             },
         .checks = 1});
    formats.push_back(
        {.name = "SourceScene",
         .ending = ".bin",
         .mutated = [samples = samplesOf("SourceScene")](Random& random) { return mutatedSample(samples, random); },
         .check =
             [](std::string_view bytes, Random&) {
                 const bool isAccepted = readSourceScene(bytes).hasValue();
                 return Verdict{.isAccepted = isAccepted, .fault = test::sourceSceneFault(bytes)};
             },
         .checks = 1});
    return formats;
}

}  // namespace rubble::attack
