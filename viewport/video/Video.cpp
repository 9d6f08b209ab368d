#include "viewport/video/Video.h"

#include "core/io/system/AtomicFile.h"
#include "core/sound/session/SoundRecorder.h"
#include "viewport/render/OffscreenRenderer.h"
#include "viewport/video/CameraListener.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace rubble {

namespace fs = std::filesystem;

namespace {

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

FrameSource framesOf(std::span<SessionPlayback> playbacks, const VideoPlan& plan) {
    const auto frame = [playbacks, &plan](OffscreenRenderer& renderer, int number, const TaskContext& task) {
        return frameAt(playbacks, renderer, plan, plan.first + number * plan.stepsPerFrame, task);
    };
    return {frame, plan.frames};
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
    return renderFrames(framesOf(playbacks, plan), folder, unfinished, task);
}

Status renderVideo(std::span<SessionPlayback> playbacks, const VideoPlan& plan, const fs::path& video,
                   const TaskContext& task) {
    if (!plan.hasSound) return renderVideo(framesOf(playbacks, plan), plan.frameRate, video, {}, task);
    if (const Status checked = checkTrackLength(secondsOf(plan)); !checked) return checked;
    SoundRecorder recorder;
    SessionPlayback& heard = playbacks.back();
    heard.setAfterStep([&recorder](const Session& session) { recorder.add(session); });
    const auto sound = [&](const fs::path& folder) -> Result<std::optional<fs::path>> {
        const fs::path file = folder / "sound.wav";
        const Result<StereoTrack> track = trackOf(recorder, heard.session().stepLength(), plan);
        if (!track) return track.error();
        const Status written = writeFileAtomically(file, wavFile(*track));
        if (!written) return written.error();
        return std::optional(file);
    };
    const Status made = renderVideo(framesOf(playbacks, plan), plan.frameRate, video, sound, task);
    heard.setAfterStep({});
    return made;
}

}  // namespace rubble
