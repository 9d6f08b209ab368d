#pragma once

#include "core/play/Replay.h"
#include "editor/play/PlayFrame.h"
#include "viewport/scene/MomentBuilder.h"

namespace rubble {

/// What is played from the start: nothing, or what was recorded.
struct PlayScript {
    SessionSettings settings;
    std::vector<TimedInput> inputs;  // ascending step
    std::uint64_t steps = 0;
    std::uint64_t begin = 0;            // the moment that is shown first, after so many steps
    std::vector<std::uint64_t> hashes;  // that the steps came to; empty: nothing is known of it
};
PlayScript scriptOf(const Replay& replay);
/// Of a play-test: its shots, for as long as it lasts, shown from a moment on.
PlayScript scriptOf(const Project& project, const PlayTest& test, std::uint64_t begin);

/// A project in play, as a window sees it: carries out what the user does, tells what becomes of it. Knows no time but steps.
/// Everything of it happens in one thread.
class PlayEngine {
public:
    /// Errors: those of Session::start() and Timeline::seek().
    static Result<std::unique_ptr<PlayEngine>> started(const std::shared_ptr<const PlayScene>& scene, PlayScript script,
                                                       const TaskContext& task = {});

    const Timeline& timeline() const { return m_timeline; }
    const Session& session() const { return m_timeline.session(); }
    /// Whether things break from this moment on: as it began, unless an input says otherwise.
    bool hasDestruction() const;

    void step();
    void seek(std::uint64_t step, const TaskContext& task);
    /// What cannot be followed is told as a notice.
    void add(const PlayInput& input);
    void fire(const std::string& name, const ShotAction& action);
    /// Each towards what a ray from the eye meets.
    void throwAlong(const Throw& thrown, const Ray& ray);
    void strikeAlong(double impulse, const Ray& ray);
    void blastAlong(const Explosion& explosion, const Ray& ray);
    /// Takes hold of what the ray meets; it is then drawn along with the ray, as far away as it was.
    void grabAlong(double force, const Ray& ray);
    void dragAlong(const Ray& ray);
    void letGo();
    /// What would be thrown now; nothing: nobody aims.
    void aim(std::optional<Throw> thrown, const Ray& ray);

    /// What moments show beside bodies. Heat is the break forecast of what is aimed, where something is; else that of the last
    /// impacts.
    void setOverlays(const PlayOverlays& overlays);

    /// Takes what happened since it was asked last, with the moment as it is.
    PlayNews takeNews();

private:
    PlayEngine(const std::shared_ptr<const PlayScene>& scene, Timeline timeline, std::vector<std::uint64_t> hashes);
    void tell();
    PlayFrame frame();
    void forecast();

    struct Aim {
        Throw thrown;
        Ray ray;
    };

    std::shared_ptr<const PlayScene> m_scene;
    Timeline m_timeline;
    MomentBuilder m_builder;
    std::vector<std::uint64_t> m_hashes;  // of the steps of a script
    bool m_beganWithDestruction = true;
    std::uint64_t m_told = 0;  // how many steps were told of
    std::optional<Aim> m_aim;
    bool m_isForecast = false;     // heat is that of the aim
    std::optional<double> m_held;  // how far from the eye what is grabbed is, m
    PlayNews m_news;
};

}  // namespace rubble
