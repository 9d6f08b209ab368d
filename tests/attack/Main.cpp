#include "tests/attack/Campaign.h"
#include "tests/support/ProgramOptions.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace {

using namespace rubble::attack;
using rubble::test::failWith;
using rubble::test::ProgramOptions;

constexpr const char* kUsage =
    R"(usage: attack [--format NAME]... [--count N] [--seed N] [--first N] [--jobs N] [--save FOLDER] [--importer FILE]
              [--verbose] [--corpus FOLDER] [--check FILE] [--print]

Feeds N damaged inputs of each format to what reads them, in limited child processes. An input must be refused with one
sentence, or be read, written, baked and simulated without a fault. Exits with 1 if one is not.

  --format NAME     Only this format or family, such as Mesh; repeatable (default: all that are listed below)
  --first N         Begin with this input: with --count 1 the one that was found
  --save FOLDER     Save what is found in FOLDER/NAME
  --importer FILE   Also attack this rubble-importer with meshes (formats Mesh/obj, Mesh/gltf …)
  --verbose         Also name the meshes on which the importer crashed or exceeded its limits
  --corpus FOLDER   Check the files in FOLDER/NAME instead
  --check FILE      Check this file as an input of the format, in this process
  --print           Print the inputs instead
)";

/// The name of a folder that is removed in the end.
class TemporaryFolder {
public:
    TemporaryFolder()
        : m_path(std::filesystem::temp_directory_path() / ("rubble-attack-" + std::to_string(::getpid()))) {}
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(m_path, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return m_path; }

private:
    std::filesystem::path m_path;
};

struct Options {
    CampaignOptions campaign;
    std::vector<std::string> formats;
    std::filesystem::path importer;
    std::filesystem::path corpus;
    std::filesystem::path checked;
    bool isPrinted = false;
};

Options optionsOf(int argumentCount, char** arguments) {
    Options options;
    ProgramOptions(kUsage)
        .value("--format", options.formats)
        .value("--count", options.campaign.count)
        .value("--seed", options.campaign.seed)
        .value("--first", options.campaign.first)
        .value("--jobs", options.campaign.jobs)
        .value("--save", options.campaign.findings)
        .value("--importer", options.importer)
        .value("--check", options.checked)
        .value("--corpus", options.corpus)
        .flag("--verbose", options.campaign.isVerbose)
        .flag("--print", options.isPrinted)
        .read(argumentCount, arguments);
    return options;
}

/// Whether a format was asked for, by its name or that of its family.
bool isWanted(const std::string& name, const std::vector<std::string>& wanted) {
    return wanted.empty() || std::ranges::any_of(wanted, [&](const std::string& one) {
               return name == one || name.starts_with(one + '/');
           });
}

int print(const Format& format, const CampaignOptions& options) {
    for (std::uint64_t k = 0; k < options.count; ++k) {
        const std::string bytes = inputOf(format, options.seed, options.first + k);
        std::fwrite(bytes.data(), 1, bytes.size(), stdout);
        std::putchar('\n');
    }
    return EXIT_SUCCESS;
}

void printImporter(const ImporterFigures& importer) {
    if (importer.opened == 0) return;
    const auto number = [](std::uint64_t count) { return static_cast<unsigned long long>(count); };
    std::printf("  importer: %llu crashed, %llu timed out, %llu out of memory; files: %llu opened, %llu refused\n",
                number(importer.crashed), number(importer.timedOut), number(importer.outOfMemory),
                number(importer.opened), number(importer.refused));
}

int check(const Format& format, const std::filesystem::path& file) {
    std::FILE* const stream = std::fopen(file.c_str(), "rb");
    if (stream == nullptr) failWith("Cannot open \"" + file.string() + "\".");
    std::string bytes;
    for (int letter = std::fgetc(stream); letter != EOF; letter = std::fgetc(stream))
        bytes += static_cast<char>(letter);
    std::fclose(stream);
    rubble::Random random(1);
    for (int k = 0; k < format.checks; ++k) {
        const Verdict verdict = format.check(bytes, random);
        if (!verdict.fault) continue;
        std::printf("%s: %s\n", file.c_str(), verdict.fault->c_str());
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}

/// Checks every file of a folder, each in a process of its own. Returns the number of those that break a promise.
int brokenInFolder(const Format& format, const std::filesystem::path& folder) {
    constexpr unsigned kSeconds = 60;
    int broken = 0;
    if (!std::filesystem::is_directory(folder)) return 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        std::fflush(nullptr);
        const pid_t process = ::fork();
        if (process < 0) failWith("Cannot start a process.");
        if (process == 0) {
            ::alarm(kSeconds);
            const int status = check(format, entry.path());
            std::fflush(nullptr);
            std::_Exit(status);
        }
        int status = 0;
        ::waitpid(process, &status, 0);
        if (WIFSIGNALED(status)) std::printf("%s: signal %d\n", entry.path().c_str(), WTERMSIG(status));
        broken += status != 0 ? 1 : 0;
    }
    return broken;
}

}  // namespace

int main(int argumentCount, char** arguments) {
    Options options = optionsOf(argumentCount, arguments);
    const TemporaryFolder folder;
    const std::vector<Format> formats = formatsOf(options.importer, folder.path());
    if (!options.corpus.empty()) {
        int broken = 0;
        for (const Format& format : formats) broken += brokenInFolder(format, options.corpus / format.name);
        return broken == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
    }
    std::printf("seed %llu, %llu inputs of each format\n%-13s %9s %9s %8s %6s %6s %7s %6s %9s\n",
                static_cast<unsigned long long>(options.campaign.seed),
                static_cast<unsigned long long>(options.campaign.count), "format", "inputs", "accepted", "played",
                "crash", "hang", "memory", "fault", "inputs/s");
    std::uint64_t broken = 0;
    for (const Format& format : formats) {
        if (!isWanted(format.name, options.formats)) continue;
        if (options.isPrinted) return print(format, options.campaign);
        if (!options.checked.empty()) return check(format, options.checked);
        const Figures figures = attacked(format, options.campaign);
        std::printf(
            "%-13s %9llu %9llu %8llu %6llu %6llu %7llu %6llu %9.0f\n", format.name.c_str(),
            static_cast<unsigned long long>(figures.inputs), static_cast<unsigned long long>(figures.accepted),
            static_cast<unsigned long long>(figures.played), static_cast<unsigned long long>(figures.findings[0]),
            static_cast<unsigned long long>(figures.findings[1]), static_cast<unsigned long long>(figures.findings[2]),
            static_cast<unsigned long long>(figures.findings[3]),
            static_cast<double>(figures.inputs) / std::max(1e-3, figures.seconds));
        printImporter(figures.importer);
        std::fflush(stdout);
        broken += figures.broken();
    }
    return broken == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
