#include "core/io/media/VideoFile.h"

#include "core/io/media/PictureSequence.h"
#include "core/io/system/AtomicFile.h"
#include "core/io/system/ChildProcess.h"
#include "core/io/system/FileErrors.h"
#include "core/io/system/Temporary.h"
#include "core/io/text/NumberText.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

namespace rubble {

namespace fs = std::filesystem;

namespace {

/// Practically unlimited: time and memory depend on video and codec, and the user can cancel.
constexpr ChildLimits kVideoLimits{.memory = ChildLimits::kUnlimited, .seconds = 24.0 * 3600.0};

/// Returns the pattern of a folder's pictures for ffmpeg, in the syntax of printf.
std::string pictureNames(const fs::path& folder) {
    std::string names;
    for (const char letter : (folder / "").string()) names += letter == '%' ? "%%" : std::string(1, letter);
    return names + PictureSequence::kFileNameFormat;
}

/// The paths are absolute: others could be read as options.
std::vector<std::string> argumentsFor(const fs::path& pictures, double rate, const std::optional<fs::path>& sound,
                                      const fs::path& video) {
    std::string rateText;
    appendNumber(rateText, rate);
    std::vector<std::string> arguments{
        "-nostdin", "-v", "error", "-y", "-framerate", rateText, "-start_number", "0", "-i", pictureNames(pictures)};
    if (sound) arguments.insert(arguments.end(), {"-i", sound->string()});
    arguments.insert(arguments.end(), {"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", video.string()});
    return arguments;
}

/// Returns the last line that is not empty: ffmpeg's final error.
std::string lastLine(const std::string& text) {
    const std::size_t end = text.find_last_not_of(" \r\n");
    if (end == std::string::npos) return {};
    const std::size_t begin = text.find_last_of('\n', end);
    return text.substr(begin == std::string::npos ? 0 : begin + 1,
                       end - (begin == std::string::npos ? 0 : begin + 1) + 1);
}

/// `part` is the hidden file that ffmpeg writes.
Status toStatus(const ChildResult& result, const fs::path& part, const fs::path& video) {
    if (result.exit == ChildExit::Exited && result.exitCode == 0) return success();
    std::string message = lastLine(result.error);
    if (const std::size_t at = message.find(part.string()); at != std::string::npos)
        message.replace(at, part.string().size(), video.string());
    return Error{ErrorCode::Io, "ffmpeg could not encode the video" + (message.empty() ? "." : ": " + message)};
}

}  // namespace

bool isVideoPath(const fs::path& path) {
    constexpr std::array kSuffixes{".mp4", ".mkv", ".mov", ".webm"};
    return std::ranges::find(kSuffixes, path.extension().string()) != kSuffixes.end();
}

std::optional<fs::path> findFfmpeg() { return findExecutable("ffmpeg"); }

Status checkVideoReplaceable(const fs::path& video) {
    struct stat old {};
    if (::stat(video.c_str(), &old) != 0) return errno == ENOENT ? success() : Status(cannotWrite(video, errno));
    if (!S_ISREG(old.st_mode))
        return Error{ErrorCode::Io, "Cannot write \"" + video.string() + "\": it exists and is not a file."};
    if (::faccessat(AT_FDCWD, video.c_str(), W_OK, AT_EACCESS) != 0) return cannotWrite(video, errno);
    return success();
}

Status encodeVideo(const fs::path& pictures, double rate, const fs::path& video, const TaskContext& task,
                   const std::optional<fs::path>& sound) {
    const std::optional<fs::path> ffmpeg = findFfmpeg();
    if (!ffmpeg) return Error{ErrorCode::NotFound, "Encoding a video needs ffmpeg, which is not installed."};
    if (const Status replaceable = checkVideoReplaceable(video); !replaceable) return replaceable;
    std::error_code error;
    const fs::path target = fs::absolute(linkTarget(video), error);
    const fs::path from = error ? fs::path() : fs::absolute(pictures, error);
    const std::optional<fs::path> heard = sound ? std::optional(fs::absolute(*sound, error)) : std::nullopt;
    if (error) return cannotWrite(video, error.value());
    removeLeftovers(target.parent_path());
    const auto folder = TemporaryFolder::create(target.parent_path());  // ffmpeg would follow a link to a file
    if (!folder) return folder.error();
    const fs::path part = (*folder)->path() / ("video" + video.extension().string());
    const Result<ChildResult> outcome = runChild(*ffmpeg, argumentsFor(from, rate, heard, part), kVideoLimits, task);
    const Status status = outcome ? toStatus(*outcome, part, video) : Status(outcome.error());
    if (!status) return status;
    const OpenFile written(part, O_RDONLY);
    if (!written.isOpen()) return cannotWrite(video, errno);
    struct stat old {};
    const int code = ::stat(target.c_str(), &old) == 0 ? inheritFrom(old, written.descriptor()) : 0;
    if (code != 0) return cannotWrite(video, code);
    if (::fsync(written.descriptor()) != 0 || ::rename(part.c_str(), target.c_str()) != 0)
        return cannotWrite(video, errno);
    return flushRenamed(target, video);
}

}  // namespace rubble
