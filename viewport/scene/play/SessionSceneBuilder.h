#pragma once

#include "core/play/analysis/Forecast.h"
#include "core/play/events/EventHistory.h"
#include "viewport/scene/SceneBuilder.h"
#include "viewport/scene/play/ImpactMarks.h"
#include "viewport/scene/play/OverlayColours.h"
#include "viewport/scene/play/PlayOverlays.h"
#include "viewport/scene/play/SessionMoment.h"
#include "viewport/scene/play/StructureLines.h"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace rubble {

/// Builds the render scenes of a running session, step by step. Every scene contains all fragments that the instances
/// can break into, hidden until they exist: a break changes marks only, and the geometry is shared from scene to scene,
/// by pointer. Projectiles and assets that are cut at the point of impact are added when they appear.
///
/// Removed debris shrinks about its centre of mass while it fades.
class SessionSceneBuilder {
public:
    /// Builds the geometry of all assets of the scene with all their fragments. Of the options, only colouring and
    /// hulls apply.
    explicit SessionSceneBuilder(std::shared_ptr<const PlayScene> scene, const SceneOptions& options = {});
    ~SessionSceneBuilder();

    /// The bodies of a session at their current poses. Writes a few numbers per body, or a few times as many for the
    /// first scene with a new body. Scenes that are no longer referenced are recycled; any thread may hold and release
    /// one.
    ///
    /// Called after each step, it also fills `previousPoses`. After anything but a single step (a start, several steps,
    /// a seek) these are empty; called again at the same step, it returns the same content.
    std::shared_ptr<const RenderScene> sceneOf(const Session& session);

    /// The same moment for a SceneRecording: without overlays, and without the dust.
    SessionMoment momentOf(const Session& session);

    /// Records what the session's last step reported, of which the following scenes show the dust. Must be called after
    /// each step, also those that are played again to seek; sceneOf() does it for the step that it shows.
    void record(const Session& session);
    /// Sets what was reported before the first scene, where the session was played without this.
    void setHistory(EventHistory history) { m_history = std::move(history); }
    /// Whether dust, chips or what a blast leaves may still change in the steps after the session's.
    bool hasDebris(const Session& session) const;

    /// Sets the overlays of the following scenes. Switching hulls rebuilds the geometry; all else is cheap.
    void setOverlays(const PlayOverlays& overlays);
    /// Sets what the heat overlay shows: a break forecast, by ascending body number. Without one, the default, it shows
    /// the recent impacts, fading within a second.
    void setForecast(std::optional<std::vector<BodyForecast>> bodies);
    /// Sets what the collapse overlay shows; nothing by default.
    void setCollapse(std::optional<BodyCollapse> collapse) { m_collapse = std::move(collapse); }

private:
    /// The geometry of an asset, or of a projectile without one.
    struct Model;
    /// The scene bodies reserved for the solids of one model of one origin.
    struct Slot {
        std::shared_ptr<const PlayAsset> asset;
        std::shared_ptr<const Polytope> hull;  // if there is no asset
        std::uint32_t first = kNone;           // scene body of solid 0; kNone: unused
    };
    /// The slots of an origin: the body as placed or thrown, and its solids if it was cut at the point of impact.
    using Slots = std::array<Slot, 2>;

    std::shared_ptr<RenderScene> freeScene();
    std::shared_ptr<RenderScene> posedScene(const Session& session);
    const Slot* slotOf(const PlayBody& body) const;
    bool isDrawnApart(const PlayBody& body) const;
    std::uint32_t solidOf(const PlayBody& body, std::uint32_t fragment) const;
    bool writePoses(const Session& session, RenderScene& scene) const;
    void addOverlays(const Session& session, RenderScene& scene);
    void addStructureLines(const Session& session, RenderScene& scene);
    std::shared_ptr<const RenderScene> sharedLayout();
    void addMarks(const Session& session, RenderScene& scene) const;
    std::vector<BodyTint> tintsOf(const Session& session) const;
    void recordImpacts(const Session& session);
    void makeModels();
    void writePreviousPoses(std::uint64_t step, RenderScene& scene) const;
    void writeSummary(std::uint64_t step, RenderScene& scene);
    void remapPrevious(const std::vector<Slots>& previousSlots);
    RenderScene emptyLayout() const;
    void layOut(const Session& session);
    void addSlot(const Session& session, std::uint32_t origin, const Slot& added);
    std::size_t modelOf(const Slot& slot);
    void applyColours();

    std::shared_ptr<const PlayScene> m_scene;
    SceneOptions m_options;
    PlayOverlays m_overlays;
    double m_arrowScale = 1.0;
    std::optional<std::vector<BodyHeat>> m_forecast;  // by ascending body number
    std::vector<BodyHeat> m_impacts;                  // by ascending body number
    std::optional<BodyCollapse> m_collapse;
    std::vector<Model> m_models;        // one per batch; the scene's assets first
    std::vector<Model> m_formerModels;  // while the bodies are laid out anew: their geometry is used again
    std::vector<Slots> m_slots;         // one per origin
    EventHistory m_history;             // whose dust is shown
    ImpactMarks m_marks;
    StructureLines m_structureLines;
    RenderScene m_layout;                               // what all scenes share, with all bodies hidden
    std::shared_ptr<const RenderScene> m_sharedLayout;  // for moments; null: not made yet
    std::vector<std::shared_ptr<RenderScene>> m_pool;
    std::shared_ptr<const RenderScene> m_previous;  // the last scene built, in the layout of m_layout
    std::uint64_t m_previousStep = 0;
    Box3 m_previousBounds;  // of its bodies at their current poses only
};

/// The body of a session that a pick names; null if it no longer exists. Linear in bodies.
const PlayBody* bodyOf(const Session& session, const PickId& pick);

}  // namespace rubble
