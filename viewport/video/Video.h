#pragma once

#include "core/base/TaskContext.h"
#include "viewport/render/Renderer.h"
#include "viewport/scene/play/SessionPlayback.h"
#include "viewport/video/FrameSource.h"

#include <filesystem>
#include <span>

namespace rubble {

/// The frames of a video and its frame rate.
struct VideoPlan {
    RenderView view;             // of each playback; its stepFraction is ignored
    int samples = 0;             // see renderImage(); 0: one pass, antialiased as `view` says
    double first = 0.0;          // step of the first frame, >= 0
    double stepsPerFrame = 1.0;  // > 0; poses between two steps are interpolated
    int frames = 1;              // at most kMaxPictures
    double frameRate = 30.0;     // frames per second
    bool hasSound = false;       // of a video: that of the last playback, heard from the camera, as fast as the frames
};

inline constexpr int kPlaybackGap = 8;  // pixels between two playbacks side by side

/// The number of frames from step `first` to step `last`.
int frameCount(double first, double last, double stepsPerFrame);

/// Renders the frames of playbacks without a display, side by side if there are several, and writes them as images: see
/// PictureSequence. The playbacks must not have started.
///
/// Errors: those of OffscreenRenderer and of PictureSequence; Cancelled.
Status renderFrames(std::span<SessionPlayback> playbacks, const VideoPlan& plan, const std::filesystem::path& folder,
                    Unfinished unfinished, const TaskContext& task = {});

/// The same, encoded as a video: see encodeVideo(). The images and the sound lie in a hidden folder beside it meanwhile
/// and are always removed.
///
/// Errors: those of renderFrames(), checkTrackLength() and encodeVideo().
Status renderVideo(std::span<SessionPlayback> playbacks, const VideoPlan& plan, const std::filesystem::path& video,
                   const TaskContext& task = {});

}  // namespace rubble
