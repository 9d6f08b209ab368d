#include "viewport/scene/play/SessionSceneBuilder.h"

#include "core/asset/finish/AssetFinish.h"
#include "core/base/Assert.h"
#include "core/geometry/hull/MassProperties.h"
#include "core/play/scene/Projectile.h"
#include "viewport/scene/BodyColours.h"
#include "viewport/scene/play/ContactLines.h"
#include "viewport/scene/play/EventEffects.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <unordered_map>

namespace rubble {
namespace {

constexpr std::size_t kPoolSize = 4;  // one on screen, one about to be, the previous one, one being written
constexpr double kCoolingRate = 3.0;  // 1/s, of the heat of impacts
constexpr double kCoolestShown = 0.02;

AssetModel projectileModel(const Polytope& hull, const SceneOptions& options) {
    AssetModel model;
    const auto geometry = std::make_shared<SceneGeometry>();
    addSolid(*geometry, {&hull, 1});
    model.geometry = geometry;
    if (options.hasHulls) model.hulls = geometry;
    model.solids = {{.volume = massOf(hull).volume, .colour = kProjectileColour}};
    return model;
}

/// The origins of all bodies' frames in those of their assets, and where courses rise on them at the start.
std::shared_ptr<const std::vector<glm::vec4>> restOffsets(const RenderScene& scene, const Project& project,
                                                          std::span<const AssetModel* const> models) {
    std::unordered_map<Id, Quat> placed;
    for (const Instance& instance : project.instances) placed.emplace(instance.id, instance.pose.orientation);
    const auto upOf = [&](const AssetModel& model, Id instance) {
        const auto found = placed.find(instance);
        const Quat upright(1.0, 0.0, 0.0, 0.0);
        return static_cast<float>(courseUp(model.asset, found != placed.end() ? found->second : upright));
    };
    std::vector<glm::vec4> offsets(scene.picks.size(), glm::vec4(0.0f));
    for (std::size_t k = 0; k < models.size(); ++k) {
        const std::vector<ModelSolid>& solids = models[k]->solids;
        for (const std::uint32_t first : scene.batches[k].firstBodies) {
            const float up = upOf(*models[k], scene.picks[first].instance);
            for (std::size_t solid = 0; solid < solids.size(); ++solid)
                offsets[first + solid] = glm::vec4(glm::vec3(solids[solid].offset), up);
        }
    }
    return std::make_shared<const std::vector<glm::vec4>>(std::move(offsets));
}

/// The pose of a body, shrunk by `fade` in [0, 1].
RenderPose poseOf(const BodyState& state, double fade, Vec3 origin) {
    if (fade <= 0.0) return renderPose(state.pose, origin);
    const Vec3 position = glm::mix(state.pose.position, state.centre, fade);
    RenderPose pose = renderPose({position, state.pose.orientation}, origin);
    pose.position.w = static_cast<float>(fade);
    return pose;
}

}  // namespace

struct SessionSceneBuilder::Model {
    std::shared_ptr<const PlayAsset> asset;
    std::shared_ptr<const Polytope> hull;  // if there is no asset
    AssetModel drawn;
};

SessionSceneBuilder::SessionSceneBuilder(std::shared_ptr<const PlayScene> scene, const SceneOptions& options)
    : m_scene(std::move(scene)), m_options(options), m_arrowScale(arrowScale(*m_scene)) {
    m_overlays.hasHulls = options.hasHulls;
    makeModels();
}

SessionSceneBuilder::~SessionSceneBuilder() = default;

void SessionSceneBuilder::makeModels() {
    m_models.clear();
    m_slots.clear();
    m_pool.clear();
    m_previous.reset();
    for (const auto& [id, asset] : m_scene->assets) modelOf({.asset = asset});
    m_layout = emptyLayout();
    m_sharedLayout.reset();
}

void SessionSceneBuilder::setOverlays(const PlayOverlays& overlays) {
    if (overlays == m_overlays) return;
    m_overlays = overlays;
    m_pool.clear();  // their colours may differ
    if (overlays.hasHulls == m_options.hasHulls) return;
    m_options.hasHulls = overlays.hasHulls;
    makeModels();
}

void SessionSceneBuilder::setForecast(std::optional<std::vector<BodyForecast>> bodies) {
    m_forecast.reset();
    if (!bodies) return;
    m_forecast.emplace();
    for (const BodyForecast& body : *bodies) m_forecast->push_back({body.body, body.largest});
}

/// An empty batch for each asset of the scene.
RenderScene SessionSceneBuilder::emptyLayout() const {
    const Project& project = m_scene->project;
    RenderScene layout{.isOutdoors = true, .hasGround = project.ground.isOn, .groundHeight = project.ground.height};
    if (!project.instances.empty()) layout.origin = project.instances.front().pose.position;
    for (std::size_t k = 0; k < m_scene->assets.size(); ++k) {
        layout.batches.push_back(batchOf(m_models[k].drawn, m_options));
    }
    return layout;
}

/// The index of a slot's model, made if missing; equal hulls share one.
std::size_t SessionSceneBuilder::modelOf(const Slot& slot) {
    const auto isIt = [&](const Model& model) {
        return model.asset == slot.asset && (model.asset != nullptr || *model.hull == *slot.hull);
    };
    const auto known = std::ranges::find_if(m_models, isIt);
    if (known != m_models.end()) return static_cast<std::size_t>(known - m_models.begin());
    Model made{slot.asset, slot.hull, {}};
    const auto former = std::ranges::find_if(m_formerModels, isIt);
    if (former != m_formerModels.end()) {
        made = std::move(*former);
        m_formerModels.erase(former);
    } else if (slot.asset != nullptr) {
        const std::shared_ptr<const Bake>& bake = slot.asset->bake;
        made.drawn = playModelOf(*findAsset(m_scene->project, bake->asset), bake, m_options);
    } else {
        made.drawn = projectileModel(*slot.hull, m_options);
    }
    m_models.push_back(std::move(made));
    return m_models.size() - 1;
}

/// The slot of a body's asset or hull; null if it has none yet.
const SessionSceneBuilder::Slot* SessionSceneBuilder::slotOf(const PlayBody& body) const {
    if (body.origin >= m_slots.size()) return nullptr;
    const Slots& slots = m_slots[body.origin];
    const auto isIts = [&](const Slot& slot) {
        return slot.asset == body.asset && slot.hull == body.hull && slot.first != kNone;
    };
    const auto found = std::ranges::find_if(slots, isIts);
    return found != slots.end() ? &*found : nullptr;
}

/// Whether the fragments of a bonded body are drawn instead of the body, since some of them are marked.
bool SessionSceneBuilder::isDrawnApart(const PlayBody& body) const {
    return m_overlays.hasCollapse && m_collapse && m_collapse->hasPartOf(body.number);
}

/// The body of the scene as which a fragment of a body is drawn: the body's solid, or the fragment's.
std::uint32_t SessionSceneBuilder::solidOf(const PlayBody& body, std::uint32_t fragment) const {
    const bool isWhole = !isDrawnApart(body) && !isPartial(body);
    const std::uint32_t drawn = isWhole ? body.fragment : fragment;
    return slotOf(body)->first + (drawn == kNone ? 0 : drawn + 1);
}

/// Writes the bodies' poses; false if a body has no slot yet. Scenes at rest are equal, whatever they were before.
bool SessionSceneBuilder::writePoses(const Session& session, RenderScene& scene) const {
    for (BodyAppearance& appearance : scene.appearances) appearance.marks = kHidden;
    std::ranges::fill(scene.poses, RenderPose());
    for (const PlayBody& body : session.bodies()) {
        if (body.role == PlayRole::Ground) continue;
        const Slot* const slot = slotOf(body);
        if (slot == nullptr) return false;
        const BodyState state = session.world().state(body.body);
        const double fade = session.fadeOf(body);
        forEachSolid(body, isDrawnApart(body), [&](std::uint32_t fragment, Vec3 offset) {
            BodyState solid = state;
            solid.pose.position += solid.pose.orientation * offset;
            const std::uint32_t index = slot->first + (fragment == kNone ? 0 : fragment + 1);
            scene.poses[index] = poseOf(solid, fade, scene.origin);
            scene.appearances[index].marks = 0;
        });
    }
    return true;
}

/// Writes the poses one step earlier, or none if they are unknown.
void SessionSceneBuilder::writePreviousPoses(std::uint64_t step, RenderScene& scene) const {
    scene.previousPoses.clear();
    if (m_previous == nullptr) return;
    if (step == m_previousStep && scene.poses == m_previous->poses) scene.previousPoses = m_previous->previousPoses;
    if (step != m_previousStep + 1) return;
    scene.previousPoses = m_previous->poses;
    for (std::size_t k = 0; k < scene.appearances.size(); ++k) {
        if ((m_previous->appearances[k].marks & kHidden) != 0) scene.previousPoses[k] = scene.poses[k];
    }
}

/// Caches the bounds; those of the previous poses are known from the previous scene.
void SessionSceneBuilder::writeSummary(std::uint64_t step, RenderScene& scene) {
    scene.summary.reset();
    const Box3 now = boundsAt(scene, scene.poses);
    SceneSummary summary{.bounds = step == m_previousStep ? boundsOf(scene) : now,
                         .now = now,
                         .hasTransparent = hasTransparentSurface(scene)};
    if (step == m_previousStep + 1 && !scene.previousPoses.empty()) summary.bounds.include(m_previousBounds);
    scene.summary = summary;
    m_previousBounds = now;
}

std::vector<BodyTint> SessionSceneBuilder::tintsOf(const Session& session) const {
    std::vector<BodyTint> tints;
    for (const PlayBody& body : session.bodies()) {
        if (body.role == PlayRole::Ground) continue;
        const bool isAsleep = session.world().state(body.body).asleep;
        const std::uint32_t first = slotOf(body)->first;
        forEachSolid(body, isDrawnApart(body), [&](std::uint32_t fragment, Vec3) {
            const std::uint32_t index = first + (fragment == kNone ? 0 : fragment + 1);
            tints.push_back({index, body.number, body.body, isAsleep, fragment});
        });
    }
    return tints;
}

/// Cools down earlier impacts and adds those of this step.
void SessionSceneBuilder::recordImpacts(const Session& session) {
    if (session.stepsDone() == m_previousStep && m_previous != nullptr) return;
    const double kept = session.stepsDone() == m_previousStep + 1 ? 1.0 - kCoolingRate * session.stepLength() : 0.0;
    for (BodyHeat& heat : m_impacts) heat.value *= kept;
    std::erase_if(m_impacts, [](const BodyHeat& heat) { return heat.value < kCoolestShown; });
    const auto heatUp = [&](std::uint32_t number, double value) {
        const auto hottest = std::ranges::lower_bound(m_impacts, number, {}, &BodyHeat::body);
        if (hottest == m_impacts.end() || hottest->body != number)
            m_impacts.insert(hottest, {number, value});
        else
            hottest->value = std::max(hottest->value, value);
    };
    // What breaks along bonds stays, and has to cool down: no more than at 1, however hard it was hit.
    for (const PlayImpact& impact : session.events().impacts)
        heatUp(impact.body, std::min(impact.damage / impact.threshold, 1.0));
    for (const PlaySplit& split : session.events().splits) heatUp(split.body.number, 1.0);
}

void SessionSceneBuilder::record(const Session& session) {
    m_history.add(session.stepsDone(), session.events());
    m_marks.record(session);
}

bool SessionSceneBuilder::hasDebris(const Session& session) const {
    return hasEventEffects(m_history, session.stepsDone(), session.stepLength());
}

void SessionSceneBuilder::addMarks(const Session& session, RenderScene& scene) const {
    const auto isApart = [this](const PlayBody& body) { return isDrawnApart(body); };
    const auto solid = [this](const PlayBody& body, std::uint32_t fragment) {
        return slotOf(body)->first + (fragment == kNone ? 0 : fragment + 1);
    };
    m_marks.addTo(scene, session, solid, isApart);
}

void SessionSceneBuilder::addStructureLines(const Session& session, RenderScene& scene) {
    const auto solid = [this](const PlayBody& body, std::uint32_t fragment) { return solidOf(body, fragment); };
    m_structureLines.addCracks(scene, session, solid);
    if (m_overlays.hasBonds) m_structureLines.addBonds(scene, session, solid);
}

void SessionSceneBuilder::addOverlays(const Session& session, RenderScene& scene) {
    scene.lines.clear();
    scene.boxes.clear();
    scene.particles.clear();
    scene.chips.clear();
    scene.decals.clear();
    scene.surfaceMarks.clear();
    record(session);
    addEventEffects(scene, m_scene->project, m_history,
                    {session.stepsDone(), session.stepLength(), session.world().gravity()});
    addMarks(session, scene);
    recordImpacts(session);
    addStructureLines(session, scene);
    if (m_overlays.hasContacts || m_overlays.hasNormals || m_overlays.hasImpulses) {
        addContactLines(scene, session, m_overlays, m_arrowScale);
    }
    const bool hasTint = m_overlays.hasIslands || m_overlays.hasBodies || m_overlays.hasSleep || m_overlays.hasHeat ||
                         m_overlays.hasCollapse;
    if (!m_overlays.hasBoxes && !hasTint) return;
    const std::vector<BodyTint> tints = tintsOf(session);
    if (m_overlays.hasBoxes) {
        for (std::size_t k = 0; k < tints.size(); ++k) {  // of several fragments of a body, the first
            if (k > 0 && tints[k].number == tints[k - 1].number) continue;
            addBodyBox(scene, session.world().box(tints[k].id), tints[k].body);
        }
    }
    for (const BodyTint& body : tints) {
        scene.appearances[body.body].outside = m_layout.appearances[body.body].outside;
        scene.appearances[body.body].inside = m_layout.appearances[body.body].inside;
    }
    const BodyCollapse* collapse = m_overlays.hasCollapse && m_collapse ? &*m_collapse : nullptr;
    tintBodies(scene, tints, session, m_overlays, m_forecast ? *m_forecast : m_impacts, collapse);
}

/// Copies the previous scene into the new layout: the bodies that have a slot in both.
void SessionSceneBuilder::remapPrevious(const std::vector<Slots>& previousSlots) {
    if (m_previous == nullptr) return;
    const auto kept = std::make_shared<RenderScene>(m_layout);
    if (!m_previous->previousPoses.empty()) kept->previousPoses = m_layout.poses;
    for (std::size_t origin = 0; origin < std::min(previousSlots.size(), m_slots.size()); ++origin) {
        for (const Slot& then : previousSlots[origin]) {
            const auto isSame = [&](const Slot& slot) { return slot.asset == then.asset && slot.hull == then.hull; };
            const auto now = std::ranges::find_if(m_slots[origin], isSame);
            if (then.first == kNone || now == m_slots[origin].end() || now->first == kNone) continue;
            const std::size_t solids = then.asset != nullptr ? 1 + then.asset->bake->fragmentCount() : 1;
            const auto copy = [&](const auto& from, auto& to) {
                std::copy_n(from.begin() + then.first, solids, to.begin() + now->first);
            };
            copy(m_previous->poses, kept->poses);
            copy(m_previous->appearances, kept->appearances);
            if (!m_previous->previousPoses.empty()) copy(m_previous->previousPoses, kept->previousPoses);
        }
    }
    m_previous = kept;
}

/// Reserves a slot for one more model of an origin.
void SessionSceneBuilder::addSlot(const Session& session, std::uint32_t origin, const Slot& added) {
    Slots& originSlots = m_slots[origin];
    const auto free = std::ranges::find(originSlots, kNone, &Slot::first);
    RUBBLE_ASSERT(free != originSlots.end());  // a whole is cut at most once
    *free = added;
    free->first = static_cast<std::uint32_t>(m_layout.picks.size());
    const std::size_t model = modelOf(added);
    const AssetModel& drawn = m_models[model].drawn;
    if (model == m_layout.batches.size()) m_layout.batches.push_back(batchOf(drawn, m_options));
    m_layout.batches[model].firstBodies.push_back(free->first);
    for (const ModelSolid& solid : drawn.solids) {
        m_layout.picks.push_back({drawn.asset.id, session.origins()[origin].instance, solid.fragment, origin});
    }
}

/// Reserves slots for all instances with all their fragments and for all other bodies; drops those of removed
/// projectiles and cuts.
void SessionSceneBuilder::layOut(const Session& session) {
    m_pool.clear();
    const auto added = m_models.begin() + static_cast<std::ptrdiff_t>(m_scene->assets.size());
    m_formerModels.assign(std::make_move_iterator(added), std::make_move_iterator(m_models.end()));
    m_models.erase(added, m_models.end());
    m_layout = emptyLayout();
    m_sharedLayout.reset();
    const std::vector<Slots> previousSlots = std::exchange(m_slots, std::vector<Slots>(session.origins().size()));
    for (std::uint32_t origin = 0; origin < m_slots.size(); ++origin) {
        const PlayOrigin& playOrigin = session.origins()[origin];
        if (playOrigin.instance != 0)
            addSlot(session, origin, {.asset = m_scene->assets.at({playOrigin.asset, playOrigin.variant})});
    }
    for (const PlayBody& body : session.bodies()) {
        if (body.role == PlayRole::Ground || slotOf(body) != nullptr) continue;
        addSlot(session, body.origin, {.asset = body.asset, .hull = body.hull});
    }
    m_formerModels.clear();
    applyColours();
    remapPrevious(previousSlots);
}

void SessionSceneBuilder::applyColours() {
    m_layout.poses.resize(m_layout.picks.size());
    m_layout.appearances.assign(m_layout.picks.size(), {.marks = kHidden});
    std::vector<const AssetModel*> models;
    for (const Model& model : m_models) models.push_back(&model.drawn);
    colourBodies(m_layout, models, m_scene->project, m_options.colouring);
    m_layout.restOffsets = restOffsets(m_layout, m_scene->project, models);
}

/// An unreferenced scene of the pool, up to date but for what writePoses() writes.
std::shared_ptr<RenderScene> SessionSceneBuilder::freeScene() {
    const auto free = std::ranges::find(m_pool, 1, &std::shared_ptr<RenderScene>::use_count);
    if (free != m_pool.end()) {
        std::atomic_thread_fence(std::memory_order_acquire);  // after the last reads of the thread that released it
        return *free;
    }
    if (m_pool.size() == kPoolSize) m_pool.erase(m_pool.begin());
    return m_pool.emplace_back(std::make_shared<RenderScene>(m_layout));
}

/// A scene with the current poses, without the previous ones.
std::shared_ptr<RenderScene> SessionSceneBuilder::posedScene(const Session& session) {
    std::shared_ptr<RenderScene> scene = freeScene();
    if (writePoses(session, *scene)) return scene;
    scene.reset();
    layOut(session);
    scene = freeScene();
    const bool isWhole = writePoses(session, *scene);
    RUBBLE_ASSERT(isWhole);
    return scene;
}

std::shared_ptr<const RenderScene> SessionSceneBuilder::sceneOf(const Session& session) {
    RUBBLE_ASSERT(&session.scene() == m_scene.get());
    const std::shared_ptr<RenderScene> scene = posedScene(session);
    writePreviousPoses(session.stepsDone(), *scene);
    addOverlays(session, *scene);
    writeSummary(session.stepsDone(), *scene);
    m_previous = scene;
    m_previousStep = session.stepsDone();
    return scene;
}

std::shared_ptr<const RenderScene> SessionSceneBuilder::sharedLayout() {
    if (m_sharedLayout == nullptr) {
        const auto layout = std::make_shared<RenderScene>(m_layout);
        layout->poses = {};
        m_sharedLayout = layout;
    }
    return m_sharedLayout;
}

SessionMoment SessionSceneBuilder::momentOf(const Session& session) {
    RUBBLE_ASSERT(&session.scene() == m_scene.get());
    const std::shared_ptr<RenderScene> scene = posedScene(session);
    scene->previousPoses.clear();
    scene->lines.clear();
    const auto solid = [this](const PlayBody& body, std::uint32_t fragment) { return solidOf(body, fragment); };
    m_structureLines.addCracks(*scene, session, solid);
    scene->surfaceMarks.clear();
    addMarks(session, *scene);
    SessionMoment moment{.layout = sharedLayout(),
                         .lines = scene->lines,
                         .marks = scene->surfaceMarks,
                         .gravity = session.world().gravity()};
    for (std::uint32_t k = 0; k < scene->appearances.size(); ++k) {
        if ((scene->appearances[k].marks & kHidden) == 0) moment.bodies.push_back({k, scene->poses[k]});
    }
    return moment;
}

const PlayBody* bodyOf(const Session& session, const PickId& pick) {
    const auto isIt = [&](const PlayBody& body) {
        if (body.role == PlayRole::Ground || body.origin != pick.origin) return false;
        if (!isPartial(body) && body.fragment == pick.fragment) return true;
        return std::ranges::binary_search(bondedFragments(body), pick.fragment);  // also where it is drawn apart
    };
    const auto found = std::ranges::find_if(session.bodies(), isIt);
    return found != session.bodies().end() ? &*found : nullptr;
}

}  // namespace rubble
