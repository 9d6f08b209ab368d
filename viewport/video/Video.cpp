#include "viewport/video/Video.h"

#include "core/io/media/PictureSequence.h"
#include "core/io/media/VideoFile.h"
#include "core/io/system/AtomicFile.h"
#include "core/io/system/Temporary.h"
#include "core/sound/session/SoundRecorder.h"
#include "viewport/render/OffscreenRenderer.h"
#include "viewport/video/CameraListener.h"
#include "viewport/video/FrameWriter.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace rubble {

namespace fs = std::filesystem;

namespace {

constexpr double kRenderingFraction = 0.9;  // of the time that a video takes; the rest is ffmpeg's

/// The frame of all playbacks at a time in steps, side by side. A fractional time interpolates towards the later step.
Result<Image> frameAt(std::span<SessionPlayback> playbacks, OffscreenRenderer& renderer, const VideoPlan& plan,
                      double time, const TaskContext& task) {
    constexpr double kRounding = 1e-6;  // steps: rounding error of sums of fractions
    const double step = std::max(0.0, std::ceil(time - kRounding));
    RenderView view = plan.view;
    view.stepFraction = std::clamp(1.0 - (step - time), 0.0, 1.0);
    std::optional<Image> frame;
    for (SessionPlayback& playback : playbacks) {
        const auto scene = playback.sceneAtStep(static_cast<std::uint64_t>(step), task);
        if (!scene) return scene.error();
        Result<Image> image = renderer.renderImage(*scene, view, plan.samples, task);
        if (!image) return image.error();
        frame = frame ? besideEachOther(*frame, *image, kPlaybackGap) : std::move(*image);
    }
    return std::move(*frame);
}

Status renderTo(std::span<SessionPlayback> playbacks, const VideoPlan& plan, PictureSequence& sequence,
                const TaskContext& task) {
    Result<OffscreenRenderer> renderer = OffscreenRenderer::create();
    if (!renderer) return renderer.error();
    const TaskContext part{.cancel = task.cancel};
    FrameWriter writer(sequence);
    for (int frame = 0; frame < plan.frames; ++frame) {
        Result<Image> image = frameAt(playbacks, *renderer, plan, plan.first + frame * plan.stepsPerFrame, part);
        if (!image) {
            (void)writer.finish();  // those before it are complete
            return image.error();
        }
        if (const Status added = writer.add(std::move(*image)); !added) return added;
        task.report(static_cast<double>(frame + 1) / plan.frames);
    }
    return writer.finish();
}

double secondsOf(const VideoPlan& plan) { return plan.frames / plan.frameRate; }

/// What was recorded, at the times of the frames and as long as they.
Result<StereoTrack> trackOf(const SoundRecorder& recorder, double stepLength, const VideoPlan& plan) {
    std::vector<SoundCue> cues;
    for (SoundCue cue : recorder.cues()) {
        cue.time = (cue.time / stepLength - plan.first) / (plan.stepsPerFrame * plan.frameRate);
        if (cue.time >= 0.0) cues.push_back(cue);
    }
    return mixedTrack(cues, secondsOf(plan), listenerAt(plan.view.camera));
}

}  // namespace

int frameCount(double first, double last, double stepsPerFrame) {
    constexpr double kRounding = 1e-6;  // frames: rounding error of quotients of fractions
    const double frames = std::floor((last - first) / stepsPerFrame + kRounding) + 1.0;
    return static_cast<int>(std::clamp(frames, 1.0, 1e9));
}

Status renderFrames(std::span<SessionPlayback> playbacks, const VideoPlan& plan, const fs::path& folder,
                    Unfinished unfinished, const TaskContext& task) {
    const auto sequence = PictureSequence::create(folder);
    if (!sequence) return sequence.error();
    const Status rendered = renderTo(playbacks, plan, **sequence, task);
    if (rendered || unfinished == Unfinished::Kept) (*sequence)->keep();
    return rendered;
}

Status renderVideo(std::span<SessionPlayback> playbacks, const VideoPlan& plan, const fs::path& video,
                   const TaskContext& task) {
    if (plan.hasSound) {
        if (const Status checked = checkTrackLength(secondsOf(plan)); !checked) return checked;
    }
    if (const Status replaceable = checkVideoReplaceable(video); !replaceable) return replaceable;
    removeLeftovers(video.parent_path());
    const auto folder = TemporaryFolder::create(video.parent_path());
    if (!folder) return folder.error();
    const fs::path pictures = (*folder)->path() / "pictures";  // the folder itself is locked already
    const auto sequence = PictureSequence::create(pictures, video);
    if (!sequence) return sequence.error();
    SoundRecorder recorder;
    SessionPlayback& heard = playbacks.back();
    if (plan.hasSound) heard.setAfterStep([&recorder](const Session& session) { recorder.add(session); });
    const Status rendered = renderTo(playbacks, plan, **sequence, task.stage(0.0, kRenderingFraction));
    heard.setAfterStep({});
    if (!rendered) return rendered;
    if (!plan.hasSound) return encodeVideo(pictures, plan.frameRate, video, task);
    const fs::path sound = (*folder)->path() / "sound.wav";
    const Result<StereoTrack> track = trackOf(recorder, heard.session().stepLength(), plan);
    if (!track) return track.error();
    const Status written = writeFileAtomically(sound, wavFile(*track));
    return written ? encodeVideo(pictures, plan.frameRate, video, task, sound) : written;
}

}  // namespace rubble
