#pragma once

#include "editor/document/Bakes.h"
#include "editor/document/Document.h"
#include "editor/play/PlayThread.h"
#include "editor/play/PlayTools.h"

namespace rubble {

enum class PlayState {
    Stopped,    // the document is shown
    Preparing,  // as soon as all is baked it will go on as `isGoingOn` says
    Paused,
    Playing
};

/// Plays a window's document: keeps a play thread to what the user wants and the document says, and holds what came of it. The
/// document is never touched.
///
/// What the user does while it waits for bakes is done as soon as it begins. Edits of the document are followed while it plays
/// where liveInputs() knows how; others begin the play anew.
class PlayController : public QObject {
    Q_OBJECT
public:
    PlayController(const Document& document, const Bakes& bakes, QObject* parent = nullptr);

    PlayState state() const { return m_state; }
    bool isOn() const { return m_state != PlayState::Stopped; }
    bool isPlaying() const { return m_state == PlayState::Playing; }
    /// There are moments to be seen and gone back to: it plays or stands still.
    bool isUnderWay() const { return m_state == PlayState::Playing || m_state == PlayState::Paused; }
    /// Begins from the start, or goes on.
    void play();
    void pause();
    void stop();
    /// Puts everything back as it was, and forgets what happened.
    void reset();
    /// Pauses, and plays one step.
    void stepOnce();
    /// Pauses at the moment after so many steps of those that are known.
    void seek(std::uint64_t step);
    /// Plays a script, of the document as it is; stands still where it begins later than at the start.
    void replay(PlayScript script);

    double timeScale() const { return m_timeScale; }
    void setTimeScale(double scale);
    /// As it is at the moment that is shown: a replay, and the way back, may switch it.
    bool hasDestruction() const { return m_hasDestruction; }
    void setDestruction(bool isOn);
    const PlayOverlays& overlays() const { return m_overlays; }
    void setOverlays(const PlayOverlays& overlays);
    const PlayTools& tools() const { return m_tools; }
    void setTools(const PlayTools& tools);

    /// What the user does in the picture, along rays from the eye. `charge` in (0, 1]: of the throw's full speed.
    void aim(const std::optional<Ray>& ray, double charge = 1.0);
    void throwAlong(const Ray& ray, double charge);
    void strikeAlong(const Ray& ray);
    void blastAlong(const Ray& ray);
    void grabAlong(const Ray& ray);
    void dragAlong(const Ray& ray);
    void letGo();
    /// Fires what is saved in the project, now.
    void fire(const Shot& shot);

    /// The newest moment; nothing before there is one.
    const std::optional<PlayFrame>& frame() const { return m_frame; }
    /// Where between the moment before and the newest one is now, in [0, 1].
    double share() const;
    const std::vector<ToldBreak>& breaks() const { return m_breaks; }
    /// Of the last kShownCosts steps.
    const std::vector<StepCost>& costs() const { return m_costs; }
    const std::optional<ShotInput>& lastShot() const { return m_lastShot; }
    /// What is played, and what came to it so far; null and nothing where nothing is played. Waits for the step at hand.
    std::shared_ptr<const PlayScene> scene() const { return m_scene; }
    PlayScript script();
    /// The project as it was when the play began.
    const Project& begunWith() const { return m_begunWith; }

    PlayThread& thread() { return m_thread; }
    /// Takes over what the play thread has to tell; done by itself while the event loop runs.
    void takeNews();

    static constexpr std::size_t kShownCosts = 300;

signals:
    void stateChanged();
    /// There is another moment.
    void framed();
    void breaksChanged();
    void toolsChanged();
    /// Time scale, destruction or overlays changed.
    void rulesChanged();
    void said(const QString& sentence);

private:
    void prepare(PlayScript script);
    void prepareAnew();
    void tryToStart();
    void follow();
    void setState(PlayState state);
    void post(PlayThread::Task task);
    void takeDestruction(const PlayFrame& frame);
    void finish(const QString& sentence);

    const Document& m_document;
    const Bakes& m_bakes;
    PlayThread m_thread;
    PlayState m_state = PlayState::Stopped;
    bool m_isGoingOn = true;  // once it is prepared
    bool m_isWaitingForBakes = false;
    std::vector<PlayThread::Task> m_waiting;  // for the bakes: what the user did meanwhile
    double m_timeScale = 1.0;
    bool m_hasDestruction = true;
    std::optional<bool> m_askedDestruction;  // that the play has not heard of yet
    PlayOverlays m_overlays;
    PlayTools m_tools;
    Project m_played;  // what the play follows now
    Project m_begunWith;
    PlayScript m_script;  // that it began, or begins with
    std::shared_ptr<const PlayScene> m_scene;
    std::optional<PlayFrame> m_frame;
    std::vector<ToldBreak> m_breaks;
    std::vector<StepCost> m_costs;
    std::optional<ShotInput> m_lastShot;
};

}  // namespace rubble
