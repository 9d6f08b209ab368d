#include "viewport/video/FrameSource.h"

#include "core/io/media/PictureSequence.h"
#include "core/io/media/VideoFile.h"
#include "core/io/system/Temporary.h"
#include "viewport/video/FrameWriter.h"

namespace rubble {

namespace fs = std::filesystem;

namespace {

constexpr double kRenderingFraction = 0.9;  // of the time that a video takes; the rest is ffmpeg's

Status renderTo(const FrameSource& source, PictureSequence& sequence, const TaskContext& task) {
    Result<OffscreenRenderer> renderer = OffscreenRenderer::create();
    if (!renderer) return renderer.error();
    const TaskContext part{.cancel = task.cancel};
    FrameWriter writer(sequence);
    for (int frame = 0; frame < source.frames; ++frame) {
        Result<Image> image = source.frameAt(*renderer, frame, part);
        if (!image) {
            (void)writer.finish();  // those before it are complete
            return image.error();
        }
        if (const Status added = writer.add(std::move(*image)); !added) return added;
        task.report(static_cast<double>(frame + 1) / source.frames);
    }
    return writer.finish();
}

}  // namespace

Status renderFrames(const FrameSource& source, const fs::path& folder, Unfinished unfinished, const TaskContext& task) {
    const auto sequence = PictureSequence::create(folder);
    if (!sequence) return sequence.error();
    const Status rendered = renderTo(source, **sequence, task);
    if (rendered || unfinished == Unfinished::Kept) (*sequence)->keep();
    return rendered;
}

Status renderVideo(const FrameSource& source, double frameRate, const fs::path& video, const SoundSource& sound,
                   const TaskContext& task) {
    if (const Status replaceable = checkVideoReplaceable(video); !replaceable) return replaceable;
    removeLeftovers(video.parent_path());
    const auto folder = TemporaryFolder::create(video.parent_path());
    if (!folder) return folder.error();
    const fs::path pictures = (*folder)->path() / "pictures";  // the folder itself is locked already
    const auto sequence = PictureSequence::create(pictures, video);
    if (!sequence) return sequence.error();
    const Status rendered = renderTo(source, **sequence, task.stage(0.0, kRenderingFraction));
    if (!rendered) return rendered;
    if (!sound) return encodeVideo(pictures, frameRate, video, task);
    const auto track = sound((*folder)->path());
    return track ? encodeVideo(pictures, frameRate, video, task, *track) : Status(track.error());
}

}  // namespace rubble
