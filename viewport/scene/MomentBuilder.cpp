#include "viewport/scene/MomentBuilder.h"

#include "core/base/Assert.h"
#include "core/geometry/MassProperties.h"
#include "viewport/scene/BodyColours.h"
#include "viewport/scene/ContactStrokes.h"
#include "viewport/scene/Dust.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace rubble {
namespace {

constexpr std::size_t kKeptMoments = 4;  // one drawn, one about to be, the last, one written
constexpr double kCooling = 3.0;         // 1/s, of impacts that heat shows
constexpr double kCold = 0.02;
constexpr Colour kMissileColour{0.30, 0.34, 0.40};

AssetModel missileModel(const Polytope& hull, const SceneOptions& options) {
    AssetModel model;
    const auto geometry = std::make_shared<SceneGeometry>();
    addPiece(*geometry, {&hull, 1});
    model.geometry = geometry;
    if (options.hasHulls) model.hulls = geometry;
    model.pieces = {{.volume = massOf(hull).volume, .colour = kMissileColour}};
    return model;
}

/// Where a body is drawn; what has faded by some share is as much smaller.
DrawnPose poseOf(const BodyState& state, double fade, Vec3 origin) {
    if (fade <= 0.0) return drawnPose(state.pose, origin);
    const Vec3 position = glm::mix(state.pose.position, state.centre, fade);
    DrawnPose pose = drawnPose({position, state.pose.orientation}, origin);
    pose.position.w = static_cast<float>(fade);
    return pose;
}

}  // namespace

struct MomentBuilder::Model {
    std::shared_ptr<const PlayAsset> asset;
    std::shared_ptr<const Polytope> hull;  // where there is no asset
    AssetModel drawn;
};

MomentBuilder::MomentBuilder(std::shared_ptr<const PlayScene> scene, const SceneOptions& options)
    : m_scene(std::move(scene)), m_options(options), m_arrowScale(arrowScale(*m_scene)) {
    m_overlays.hasHulls = options.hasHulls;
    makeModels();
}

MomentBuilder::~MomentBuilder() = default;

void MomentBuilder::makeModels() {
    m_models.clear();
    m_places.clear();
    m_moments.clear();
    m_last.reset();
    for (const auto& [id, asset] : m_scene->assets) modelOf({.asset = asset});
    m_layout = emptyLayout();
}

void MomentBuilder::setOverlays(const PlayOverlays& overlays) {
    if (overlays == m_overlays) return;
    m_overlays = overlays;
    m_moments.clear();  // their colours may be others'
    if (overlays.hasHulls == m_options.hasHulls) return;
    m_options.hasHulls = overlays.hasHulls;
    makeModels();
}

void MomentBuilder::setForecast(std::optional<std::vector<BodyForecast>> bodies) {
    m_forecast.reset();
    m_surfaces.clear();
    if (!bodies) return;
    m_surfaces = std::move(*bodies);
    std::erase_if(m_surfaces, [](const BodyForecast& body) { return !std::isfinite(body.threshold); });
    std::ranges::sort(m_surfaces, {}, &BodyForecast::body);
    m_forecast.emplace();
    for (const BodyForecast& body : m_surfaces) m_forecast->push_back({body.body, body.largest});
}

/// With a batch for each of the scene's assets, and nothing in it.
RenderScene MomentBuilder::emptyLayout() const {
    const Project& project = m_scene->project;
    RenderScene layout{.isOutdoors = true, .hasGround = project.ground.isOn, .groundHeight = project.ground.height};
    if (!project.instances.empty()) layout.origin = project.instances.front().pose.position;
    for (std::size_t k = 0; k < m_scene->assets.size(); ++k) {
        layout.batches.push_back({m_models[k].drawn.geometry, m_models[k].drawn.hulls, {}});
    }
    return layout;
}

/// The model of what has a place; of hulls that are alike there is one.
std::size_t MomentBuilder::modelOf(const Place& place) {
    const auto isIt = [&](const Model& model) {
        return model.asset == place.asset && (model.asset != nullptr || *model.hull == *place.hull);
    };
    const auto known = std::ranges::find_if(m_models, isIt);
    if (known != m_models.end()) return static_cast<std::size_t>(known - m_models.begin());
    Model made{place.asset, place.hull, {}};
    if (place.asset != nullptr) {
        const std::shared_ptr<const Bake>& bake = place.asset->bake;
        made.drawn = playModelOf(*findAsset(m_scene->project, bake->asset), bake, m_options);
    } else {
        made.drawn = missileModel(*place.hull, m_options);
    }
    m_models.push_back(std::move(made));
    return m_models.size() - 1;
}

std::uint32_t MomentBuilder::sceneBodyOf(const PlayBody& body) const {
    if (body.origin >= m_places.size()) return kNone;
    for (const Place& place : m_places[body.origin]) {
        const bool isIts = place.asset == body.asset && place.hull == body.hull && place.first != kNone;
        if (isIts) return body.fragment == kNone ? place.first : place.first + body.fragment + 1;
    }
    return kNone;
}

/// Writes where bodies are; false where one has no place yet.
bool MomentBuilder::isWritten(const Session& session, RenderScene& moment) const {
    for (BodyLook& look : moment.looks) {
        look.marks = kHidden;
        look.heat = 0;
    }
    for (const PlayBody& body : session.bodies()) {
        if (body.role == PlayRole::Ground) continue;
        const std::uint32_t place = sceneBodyOf(body);
        if (place == kNone) return false;
        moment.motions[place] = poseOf(session.world().state(body.body), session.fadeOf(body), moment.origin);
        moment.looks[place].marks = 0;
    }
    return true;
}

/// Writes where bodies were a step before, or nothing where it is not known.
void MomentBuilder::writeEarlier(std::uint64_t step, RenderScene& moment) const {
    moment.earlier.clear();
    if (m_last == nullptr) return;
    if (step == m_lastStep && moment.motions == m_last->motions) moment.earlier = m_last->earlier;
    if (step != m_lastStep + 1) return;
    moment.earlier = m_last->motions;
    for (std::size_t k = 0; k < moment.looks.size(); ++k) {
        if ((m_last->looks[k].marks & kHidden) != 0) moment.earlier[k] = moment.motions[k];
    }
}

/// Where bodies were is not asked again where the last moment told it.
void MomentBuilder::summarize(std::uint64_t step, RenderScene& moment) {
    moment.summary.reset();
    const Box3 now = boundsAt(moment, moment.motions);
    SceneSummary summary{.bounds = step == m_lastStep ? boundsOf(moment) : now};
    if (step == m_lastStep + 1 && !moment.earlier.empty()) summary.bounds.include(m_lastBounds);
    moment.summary = summary;
    m_lastBounds = now;
}

std::vector<BodyTint> MomentBuilder::tintsOf(const Session& session) const {
    std::vector<BodyTint> tints;
    for (const PlayBody& body : session.bodies()) {
        if (body.role == PlayRole::Ground) continue;
        tints.push_back({sceneBodyOf(body), body.number, body.body, session.world().state(body.body).asleep});
    }
    return tints;
}

/// Cools what was hit earlier, and heats what is hit now.
void MomentBuilder::noteImpacts(const Session& session) {
    if (session.stepsDone() == m_lastStep && m_last != nullptr) return;
    const double kept = session.stepsDone() == m_lastStep + 1 ? 1.0 - kCooling * session.stepLength() : 0.0;
    for (BodyHeat& heat : m_impacts) heat.value *= kept;
    std::erase_if(m_impacts, [](const BodyHeat& heat) { return heat.value < kCold; });
    for (const PlayImpact& impact : session.events().impacts) {
        const auto place = std::ranges::lower_bound(m_impacts, impact.body, {}, &BodyHeat::body);
        const double value = impact.damage / impact.threshold;
        if (place == m_impacts.end() || place->body != impact.body)
            m_impacts.insert(place, {impact.body, value});
        else
            place->value = std::max(place->value, value);
    }
}

void MomentBuilder::decorate(const Session& session, RenderScene& moment) {
    moment.strokes.clear();
    moment.boxes.clear();
    moment.puffs.clear();
    moment.heats.clear();
    addDust(moment, session);
    noteImpacts(session);
    if (m_overlays.hasContacts || m_overlays.hasNormals || m_overlays.hasImpulses) {
        addContactStrokes(moment, session, m_overlays, m_arrowScale);
    }
    if (!m_overlays.hasBoxes && !m_overlays.hasIslands && !m_overlays.hasSleep && !m_overlays.hasHeat) return;
    const std::vector<BodyTint> tints = tintsOf(session);
    if (m_overlays.hasBoxes) {
        for (const BodyTint& body : tints) addBodyBox(moment, session.world().box(body.id), body.body);
    }
    for (const BodyTint& body : tints) {
        moment.looks[body.body].outside = m_layout.looks[body.body].outside;
        moment.looks[body.body].inside = m_layout.looks[body.body].inside;
    }
    tintBodies(moment, tints, session, m_overlays, m_forecast ? *m_forecast : m_impacts);
    if (m_overlays.hasHeat) heatSurfaces(tints, moment);
}

/// Only bodies that can break have a row: the many pieces that cannot cost nothing.
void MomentBuilder::heatSurfaces(std::span<const BodyTint> bodies, RenderScene& moment) const {
    if (m_surfaces.empty()) return;
    moment.heatSource = heatSource(m_surfaces.front().missile, moment.origin);
    for (const BodyTint& body : bodies) {
        const auto found = std::ranges::lower_bound(m_surfaces, body.number, {}, &BodyForecast::body);
        if (found == m_surfaces.end() || found->body != body.number) continue;
        moment.heats.push_back(surfaceHeat(*found, moment.origin));
        moment.looks[body.body].heat = static_cast<std::uint32_t>(moment.heats.size());
    }
}

/// Lays the last moment out anew, with what had its place and has one.
void MomentBuilder::keepLast(const std::vector<Places>& placesThen) {
    if (m_last == nullptr) return;
    const auto kept = std::make_shared<RenderScene>(m_layout);
    if (!m_last->earlier.empty()) kept->earlier = m_layout.motions;
    for (std::size_t origin = 0; origin < std::min(placesThen.size(), m_places.size()); ++origin) {
        for (const Place& then : placesThen[origin]) {
            const auto isIts = [&](const Place& place) { return place.asset == then.asset && place.hull == then.hull; };
            const auto now = std::ranges::find_if(m_places[origin], isIts);
            if (then.first == kNone || now == m_places[origin].end() || now->first == kNone) continue;
            const std::size_t pieces = then.asset != nullptr ? 1 + then.asset->bake->fragmentCount() : 1;
            const auto copy = [&](const auto& from, auto& to) {
                std::copy_n(from.begin() + then.first, pieces, to.begin() + now->first);
            };
            copy(m_last->motions, kept->motions);
            copy(m_last->looks, kept->looks);
            if (!m_last->earlier.empty()) copy(m_last->earlier, kept->earlier);
        }
    }
    m_last = kept;
}

/// Gives one more model of an origin its place.
void MomentBuilder::addPlace(const Session& session, std::uint32_t origin, const Place& added) {
    Places& places = m_places[origin];
    const auto free = std::ranges::find(places, kNone, &Place::first);
    RUBBLE_ASSERT(free != places.end());  // a whole is cut at most once
    *free = added;
    free->first = static_cast<std::uint32_t>(m_layout.picks.size());
    const std::size_t model = modelOf(added);
    const AssetModel& drawn = m_models[model].drawn;
    if (model == m_layout.batches.size()) m_layout.batches.push_back({drawn.geometry, drawn.hulls, {}});
    m_layout.batches[model].firstBodies.push_back(free->first);
    for (const ModelPiece& piece : drawn.pieces) {
        m_layout.picks.push_back({drawn.asset.id, session.origins()[origin].instance, piece.fragment, origin});
    }
}

/// Gives all that is there its place, and all that instances can become. What was thrown or cut and is gone has none.
void MomentBuilder::layOut(const Session& session) {
    m_moments.clear();
    m_models.resize(m_scene->assets.size());
    m_layout = emptyLayout();
    const std::vector<Places> placesThen = std::exchange(m_places, std::vector<Places>(session.origins().size()));
    for (std::uint32_t origin = 0; origin < m_places.size(); ++origin) {
        const PlayOrigin& told = session.origins()[origin];
        if (told.instance != 0) addPlace(session, origin, {.asset = m_scene->assets.at({told.asset, told.variant})});
    }
    for (const PlayBody& body : session.bodies()) {
        if (body.role == PlayRole::Ground || sceneBodyOf(body) != kNone) continue;
        addPlace(session, body.origin, {.asset = body.asset, .hull = body.hull});
    }
    paint();
    keepLast(placesThen);
}

void MomentBuilder::paint() {
    m_layout.motions.resize(m_layout.picks.size());
    m_layout.looks.assign(m_layout.picks.size(), {.marks = kHidden});
    std::vector<const AssetModel*> models;
    for (const Model& model : m_models) models.push_back(&model.drawn);
    paintBodies(m_layout, models, m_scene->project, m_options.colouring);
}

/// A scene that nobody looks at, like all moments but for what isWritten() writes.
std::shared_ptr<RenderScene> MomentBuilder::freeMoment() {
    const auto free = std::ranges::find(m_moments, 1, &std::shared_ptr<RenderScene>::use_count);
    if (free != m_moments.end()) {
        std::atomic_thread_fence(std::memory_order_acquire);  // after what the thread that let go of it read
        return *free;
    }
    if (m_moments.size() == kKeptMoments) m_moments.erase(m_moments.begin());
    return m_moments.emplace_back(std::make_shared<RenderScene>(m_layout));
}

/// Without what was earlier.
std::shared_ptr<RenderScene> MomentBuilder::writtenMoment(const Session& session) {
    std::shared_ptr<RenderScene> moment = freeMoment();
    if (isWritten(session, *moment)) return moment;
    moment.reset();
    layOut(session);
    moment = freeMoment();
    const bool isWhole = isWritten(session, *moment);
    RUBBLE_ASSERT(isWhole);
    return moment;
}

std::shared_ptr<const RenderScene> MomentBuilder::momentOf(const Session& session) {
    RUBBLE_ASSERT(&session.scene() == m_scene.get());
    const std::shared_ptr<RenderScene> moment = writtenMoment(session);
    writeEarlier(session.stepsDone(), *moment);
    decorate(session, *moment);
    summarize(session.stepsDone(), *moment);
    m_last = moment;
    m_lastStep = session.stepsDone();
    return moment;
}

const PlayBody* bodyOf(const Session& session, const PickId& pick) {
    const auto isIt = [&](const PlayBody& body) {
        return body.role != PlayRole::Ground && body.origin == pick.origin && body.fragment == pick.fragment;
    };
    const auto found = std::ranges::find_if(session.bodies(), isIt);
    return found != session.bodies().end() ? &*found : nullptr;
}

}  // namespace rubble
