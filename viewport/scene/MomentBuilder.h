#pragma once

#include "core/play/Forecast.h"
#include "viewport/scene/MomentColours.h"
#include "viewport/scene/PlayOverlays.h"
#include "viewport/scene/SceneBuilder.h"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace rubble {

/// Makes scenes of a session, moment by moment. All that instances can become lies in every one of them, what is not there
/// marked as hidden: a break moves marks, and geometry is the same from moment to moment, by pointer. What is thrown, and
/// assets that were cut where they were hit, come to it when they appear.
///
/// Debris shrinks as it fades, about its centre of mass.
class MomentBuilder {
public:
    /// Makes the geometry of all that the scene's assets can become. Of the options, colouring and hulls count.
    explicit MomentBuilder(std::shared_ptr<const PlayScene> scene, const SceneOptions& options = {});
    ~MomentBuilder();

    /// The bodies of a session over the scene where they are now; the ground is drawn as any scene's. A few numbers a body, or
    /// for the first moment with something new in it, a few times as much. A scene that nobody holds any more is used
    /// again; any thread may hold it and let go of it.
    ///
    /// Called after each step, it says where bodies were a step before. After anything but one step (a start, several
    /// steps, a way back) nothing moves in the scene; asked again for the same moment it says the same.
    std::shared_ptr<const RenderScene> momentOf(const Session& session);

    /// What moments show from now on. With hulls as it was it costs nothing; hulls that come or go are new geometry.
    void setOverlays(const PlayOverlays& overlays);
    /// What heat shows from now on: a forecast, place by place on surfaces. Without one, the default, it shows the impacts of
    /// the last steps that moments were made of, cooling down within a second.
    void setForecast(std::optional<std::vector<BodyForecast>> bodies);

private:
    /// What can be drawn: all of an asset, or something thrown that is none.
    struct Model;
    /// Where the pieces of a model lie in the scene for one origin.
    struct Place {
        std::shared_ptr<const PlayAsset> asset;
        std::shared_ptr<const Polytope> hull;  // where there is no asset
        std::uint32_t first = kNone;           // body of piece 0 in the scene; kNone: there is no such place
    };
    /// Of an origin: as it was placed or thrown, and what it was cut into where it was hit.
    using Places = std::array<Place, 2>;

    std::shared_ptr<RenderScene> freeMoment();
    std::shared_ptr<RenderScene> writtenMoment(const Session& session);
    std::uint32_t sceneBodyOf(const PlayBody& body) const;
    bool isWritten(const Session& session, RenderScene& moment) const;
    void heatSurfaces(std::span<const BodyTint> bodies, RenderScene& moment) const;
    void decorate(const Session& session, RenderScene& moment);
    std::vector<BodyTint> tintsOf(const Session& session) const;
    void noteImpacts(const Session& session);
    void makeModels();
    void writeEarlier(std::uint64_t step, RenderScene& moment) const;
    void summarize(std::uint64_t step, RenderScene& moment);
    void keepLast(const std::vector<Places>& placesThen);
    RenderScene emptyLayout() const;
    void layOut(const Session& session);
    void addPlace(const Session& session, std::uint32_t origin, const Place& added);
    std::size_t modelOf(const Place& place);
    void paint();

    std::shared_ptr<const PlayScene> m_scene;
    SceneOptions m_options;
    PlayOverlays m_overlays;
    double m_arrowScale = 1.0;
    std::optional<std::vector<BodyHeat>> m_forecast;  // ascending number
    std::vector<BodyForecast> m_surfaces;             // the same, of those that may break
    std::vector<BodyHeat> m_impacts;                  // the same
    std::vector<Model> m_models;                      // those of the scene's assets first; one a batch
    std::vector<Places> m_places;                     // one an origin
    RenderScene m_layout;                             // what all moments share, with everything hidden
    std::vector<std::shared_ptr<RenderScene>> m_moments;
    std::shared_ptr<const RenderScene> m_last;  // the last moment, laid out as m_layout is
    std::uint64_t m_lastStep = 0;
    Box3 m_lastBounds;  // of its bodies where they are, not where they were
};

/// The body that a click in a moment's scene has hit; null where it is gone. Linear in bodies.
const PlayBody* bodyOf(const Session& session, const PickId& pick);

}  // namespace rubble
