#include "viewport/video/ContactSheetPainter.h"

#include "core/asset/project/AssetShape.h"
#include "core/base/OutOfMemory.h"
#include "core/base/limits/Threads.h"
#include "viewport/scene/play/SessionSceneBuilder.h"

#include <cmath>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace rubble {
namespace {

constexpr double kFallMargin = 1.0;  // space around the instance ÷ its height, for falling debris
constexpr double kAzimuthOffset =
    0.35;  // rad, to the right of the shot, so that the projectile does not hide the impact

/// The bounding box of an instance in the world.
Box3 boundsOfInstance(const Instance& instance, const Asset& asset) {
    const Box3 local = boundsOf(asset);
    Box3 box;
    for (int corner = 0; corner < 8; ++corner) {
        box.include(instance.pose.position + instance.pose.orientation * local.corner(corner));
    }
    return box;
}

/// The target of a shot and, if it is a throw, its origin.
struct ShotPath {
    Vec3 at;
    std::optional<Vec3> from;
};
std::optional<ShotPath> pathOfShot(const SheetRequest& request) {
    for (const Shot& shot : request.project.shots) {
        if (request.stage->shots.empty() || shot.id != request.stage->shots.front()) continue;
        if (const auto* thrown = std::get_if<Throw>(&shot.action)) return ShotPath{thrown->to, thrown->from};
        if (const auto* blow = std::get_if<Hammer>(&shot.action)) return ShotPath{blow->at, std::nullopt};
        return ShotPath{std::get<Blast>(shot.action).at, std::nullopt};
    }
    return std::nullopt;
}

/// The box around the instance nearest to the shot, or the first one, with space for falling debris.
Box3 boundsUnderShot(const SheetRequest& request) {
    const std::optional<ShotPath> shot = pathOfShot(request);
    const Asset& asset = *findAsset(request.project, request.asset);
    Box3 nearest;
    for (const Instance& instance : request.project.instances) {
        if (instance.asset != request.asset) continue;
        const Box3 box = boundsOfInstance(instance, asset);
        const bool isNearer = shot && glm::distance(box.centre(), shot->at) < glm::distance(nearest.centre(), shot->at);
        if (nearest.isEmpty() || isNearer) nearest = box;
    }
    const double margin = kFallMargin * (nearest.max.y - nearest.min.y);
    return {nearest.min - Vec3(margin, 0.0, margin), nearest.max + Vec3(margin, margin / 2.0, margin)};
}

/// The camera's orientation: from beside the shot's origin, or as the style says.
Camera orientedFor(const SheetRequest& request, const SheetStyle& style) {
    Camera camera = alignedTo({}, style.view);
    if (!request.stage) {
        camera.projection = Projection::Orthographic;
        return camera;
    }
    const std::optional<ShotPath> shot = pathOfShot(request);
    if (!shot || !shot->from) return camera;
    const Vec3 back = *shot->from - shot->at;
    if (back.x != 0.0 || back.z != 0.0) camera.azimuth = std::atan2(back.x, back.z) + kAzimuthOffset;
    return camera;
}

RenderScene sceneAtRest(const Project& project, const SheetEntry& entry, const SheetStyle& style) {
    AssetBakes bakes;
    bakes[{entry.asset.id}] = entry.bake;
    return sceneOf(projectWith(project, entry.asset), bakes, {.asset = entry.asset.id, .colouring = style.colouring});
}

/// Passes entries from the threads that make them to the one that renders them.
class EntryQueue {
public:
    void push(SheetEntry entry) {
        const std::lock_guard lock(m_guard);
        m_entries.push_back(std::move(entry));
        m_changed.notify_one();
    }
    /// Marks the end of the entries.
    void end(Status status) {
        const std::lock_guard lock(m_guard);
        m_end = std::move(status);
        m_changed.notify_one();
    }
    /// Waits for the next entry; nothing at the end.
    std::optional<SheetEntry> next() {
        std::unique_lock lock(m_guard);
        m_changed.wait(lock, [this] { return !m_entries.empty() || m_end; });
        if (m_entries.empty()) return std::nullopt;
        SheetEntry entry = std::move(m_entries.front());
        m_entries.pop_front();
        return entry;
    }
    const Status& status() const { return *m_end; }

private:
    std::mutex m_guard;
    std::condition_variable m_changed;
    std::deque<SheetEntry> m_entries;
    std::optional<Status> m_end;
};

}  // namespace

Result<ContactSheetPainter> ContactSheetPainter::create(const SheetRequest& request, const SheetStyle& style) {
    Result<OffscreenRenderer> renderer = OffscreenRenderer::create();
    if (!renderer) return renderer.error();
    return ContactSheetPainter(std::move(*renderer), request, style);
}

ContactSheetPainter::ContactSheetPainter(OffscreenRenderer renderer, const SheetRequest& request,
                                         const SheetStyle& style)
    : m_renderer(std::move(renderer)), m_project(request.project), m_style(style) {
    const Box3 box = request.stage ? boundsUnderShot(request)
                                   : boundsOf(sceneOf(request.project, {}, {.asset = request.asset, .isWhole = true}));
    m_view.size = style.size;
    m_view.settings.theme = style.theme;
    m_view.settings.hasAxes = false;
    m_view.camera = framing(orientedFor(request, style), box, style.size);
}

Result<Image> ContactSheetPainter::renderImage(const SheetEntry& entry, const TaskContext& task) {
    if (entry.fault) return Error{ErrorCode::BadInput, *entry.fault};
    std::shared_ptr<const RenderScene> scene;
    if (entry.session) {
        const std::shared_ptr<const PlayScene> played(entry.session, &entry.session->scene());
        SessionSceneBuilder builder(played, {.colouring = m_style.colouring});
        builder.setHistory(entry.history);
        scene = builder.sceneOf(*entry.session);
    } else {
        scene = std::make_shared<const RenderScene>(sceneAtRest(m_project, entry, m_style));
    }
    return m_renderer.renderImage(std::move(scene), m_view, m_style.samples, task);
}

Status drawContactSheet(const SheetRequest& request, const SheetStyle& style,
                        const std::function<void(SheetEntry, std::optional<Image>)>& take, const TaskContext& task) {
    Result<ContactSheetPainter> painter = ContactSheetPainter::create(request, style);
    if (!painter) return painter.error();
    EntryQueue queue;
    TaskContext making{.cancel = task.cancel, .progress = {}, .threads = task.threads};
    const auto make = [&] {
        queue.end(orOutOfMemory("making the contact sheet", [&] {
            return makeContactSheet(
                request, [&](SheetEntry entry) { queue.push(std::move(entry)); }, making);
        }));
    };
    const std::jthread generator = startedThread(make);
    if (!generator.joinable()) make();  // one after the other
    Status drawn = success();
    std::size_t done = 0;
    while (std::optional<SheetEntry> entry = queue.next()) {
        if (!drawn) continue;
        std::optional<Image> picture;
        if (!entry->fault) {
            Result<Image> image = painter->renderImage(*entry, {.cancel = task.cancel, .progress = {}});
            if (image) picture = std::move(*image);
            if (!image) drawn = image.error();
        }
        if (!drawn) {
            making.cancel.cancel();
            continue;
        }
        entry->session = nullptr;
        entry->history = {};
        take(std::move(*entry), std::move(picture));
        task.report(static_cast<double>(++done) / static_cast<double>(request.variants.size()));
    }
    return drawn ? queue.status() : drawn;
}

}  // namespace rubble
