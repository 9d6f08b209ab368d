#include "core/io/FilmFile.h"

#include "core/io/ChildProcess.h"
#include "core/io/NumberText.h"
#include "core/io/PictureSequence.h"

#include <algorithm>
#include <array>
#include <limits>
#include <system_error>

namespace rubble {

namespace fs = std::filesystem;

namespace {

/// Nobody knows how long a film takes, nor what its codec needs: the user may cancel it.
constexpr ChildLimits kFilmLimits{.memory = std::numeric_limits<std::size_t>::max(), .seconds = 24.0 * 3600.0};

/// A folder's pictures, as ffmpeg reads their names: by printf's rules.
std::string pictureNames(const fs::path& folder) {
    std::string names;
    for (const char letter : (fs::absolute(folder) / "").string())
        names += letter == '%' ? "%%" : std::string(1, letter);
    return names + PictureSequence::kNames;
}

std::vector<std::string> argumentsFor(const fs::path& pictures, double rate, const fs::path& film) {
    std::string rateText;
    appendNumber(rateText, rate);
    return {"-nostdin",
            "-v",
            "error",
            "-y",
            "-framerate",
            rateText,
            "-start_number",
            "0",
            "-i",
            pictureNames(pictures),
            "-vf",
            "pad=ceil(iw/2)*2:ceil(ih/2)*2",
            "-pix_fmt",
            "yuv420p",
            fs::absolute(film).string()};
}

/// The last line that says something: what came before led to it.
std::string lastLine(const std::string& text) {
    const std::size_t end = text.find_last_not_of(" \r\n");
    if (end == std::string::npos) return {};
    const std::size_t begin = text.find_last_of('\n', end);
    return text.substr(begin == std::string::npos ? 0 : begin + 1,
                       end - (begin == std::string::npos ? 0 : begin + 1) + 1);
}

Status ended(const ChildOutcome& outcome) {
    if (outcome.end == ChildEnd::Exited && outcome.exitCode == 0) return success();
    const std::string said = lastLine(outcome.error);
    return Error{ErrorCode::Io, "ffmpeg could not make the film" + (said.empty() ? "." : ": " + said)};
}

}  // namespace

bool isFilmPath(const fs::path& path) {
    constexpr std::array kSuffixes{".mp4", ".mkv", ".mov", ".webm"};
    return std::ranges::find(kSuffixes, path.extension().string()) != kSuffixes.end();
}

std::optional<fs::path> ffmpegProgram() { return programInPath("ffmpeg"); }

Status encodeFilm(const fs::path& pictures, double rate, const fs::path& film, const TaskContext& task) {
    const std::optional<fs::path> ffmpeg = ffmpegProgram();
    if (!ffmpeg) return Error{ErrorCode::NotFound, "There is no ffmpeg on this machine to make a film with."};
    const fs::path part = film.parent_path() / ("." + film.stem().string() + ".part" + film.extension().string());
    const Result<ChildOutcome> outcome = runChild(*ffmpeg, argumentsFor(pictures, rate, part), kFilmLimits, task);
    Status made = outcome ? ended(*outcome) : Status(outcome.error());
    std::error_code fault, ignored;
    if (made) fs::rename(part, film, fault);
    if (fault) made = Error{ErrorCode::Io, "Cannot write \"" + film.string() + "\": " + fault.message() + "."};
    if (!made) fs::remove(part, ignored);
    return made;
}

}  // namespace rubble
