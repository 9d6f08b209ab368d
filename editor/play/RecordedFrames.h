#pragma once

#include "editor/play/PlayFrame.h"
#include "viewport/scene/play/SceneRecording.h"

#include <mutex>

namespace rubble {

/// The frames of the steps that were played, so that one that is sought is shown before the session is there. Written
/// by the thread that plays, read by any other, which waits for no step.
class RecordedFrames {
public:
    /// `stepLength`: of the session, s.
    RecordedFrames(std::shared_ptr<const PlayScene> scene, double stepLength,
                   std::size_t maxBytes = kMaxRecordingBytes);

    /// What of a step is recorded.
    struct Step {
        std::uint64_t step = 0;
        PlayStatistics statistics;
        bool hasDestruction = true;
    };
    /// Whether the step need not be added: it or a later one is recorded.
    bool isKnown(std::uint64_t step) const;
    /// Adds a step after the last one, with what it has reported.
    void add(const Step& step, SessionMoment moment, const PlayEvents& events);
    void discardAfter(std::uint64_t step);
    void clear();
    /// Sets the newest frame, whose timeline the recorded ones have.
    void setNewest(const PlayFrame& frame);

    /// The frame of the last recorded step until this one, which is none of the session's state yet; nothing before the
    /// first.
    std::optional<PlayFrame> frameUntil(std::uint64_t step) const;

private:
    mutable std::mutex m_mutex;  // guards all below
    SceneRecording m_scenes;
    std::vector<Step> m_steps;  // ascending
    PlayFrame m_newest;         // without its scene
};

}  // namespace rubble
