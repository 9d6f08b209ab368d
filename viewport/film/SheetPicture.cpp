#include "viewport/film/SheetPicture.h"

#include "viewport/scene/MomentBuilder.h"

#include <cmath>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace rubble {
namespace {

constexpr double kRoomToFall = 1.0;      // of its height, around what a shot is to bring down
constexpr double kBesideShooter = 0.35;  // rad, to the right: from where a shot and what it does are both seen

/// A box around an instance where it stands.
Box3 boundsOfInstance(const Instance& instance, const Prism& prism) {
    const Box2 outline = boundsOf(prism.outline.outer);
    const Box3 local{Vec3(outline.min, -prism.depth / 2.0), Vec3(outline.max, prism.depth / 2.0)};
    Box3 box;
    for (int corner = 0; corner < 8; ++corner) {
        box.include(instance.pose.position + instance.pose.orientation * local.corner(corner));
    }
    return box;
}

/// Where a shot is meant to act, and from where it comes.
struct ShotPlace {
    Vec3 at;
    std::optional<Vec3> from;
};
std::optional<ShotPlace> placeOfShot(const SheetOrder& order) {
    for (const Shot& shot : order.project.shots) {
        if (order.stage->shots.empty() || shot.id != order.stage->shots.front()) continue;
        if (const auto* thrown = std::get_if<Throw>(&shot.action)) return ShotPlace{thrown->to, thrown->from};
        if (const auto* blow = std::get_if<Hammer>(&shot.action)) return ShotPlace{blow->at, std::nullopt};
        return ShotPlace{std::get<Explosion>(shot.action).at, std::nullopt};
    }
    return std::nullopt;
}

/// Around the instance that is nearest to the shot, or the first one, with room for what falls off it.
Box3 boundsUnderShot(const SheetOrder& order) {
    const std::optional<ShotPlace> shot = placeOfShot(order);
    const Prism& prism = findAsset(order.project, order.asset)->prism;
    Box3 nearest;
    for (const Instance& instance : order.project.instances) {
        if (instance.asset != order.asset) continue;
        const Box3 box = boundsOfInstance(instance, prism);
        const bool isNearer = shot && glm::distance(box.centre(), shot->at) < glm::distance(nearest.centre(), shot->at);
        if (nearest.isEmpty() || isNearer) nearest = box;
    }
    const double reach = kRoomToFall * (nearest.max.y - nearest.min.y);
    return {nearest.min - Vec3(reach, 0.0, reach), nearest.max + Vec3(reach, reach / 2.0, reach)};
}

/// The camera turned to what a shot does, from beside whoever fires it; or as the look says.
Camera turned(const SheetOrder& order, const SheetLook& look) {
    Camera camera = turnedTo({}, look.view);
    if (!order.stage) {
        camera.projection = Projection::Orthographic;  // as in the plane
        return camera;
    }
    const std::optional<ShotPlace> shot = placeOfShot(order);
    if (!shot || !shot->from) return camera;
    const Vec3 back = *shot->from - shot->at;
    if (back.x != 0.0 || back.z != 0.0) camera.azimuth = std::atan2(back.x, back.z) + kBesideShooter;
    return camera;
}

RenderScene sceneAtRest(const Project& project, const SheetEntry& entry, const SheetLook& look) {
    AssetBakes bakes;
    bakes[{entry.asset.id}] = entry.bake;
    return sceneOf(projectWith(project, entry.asset), bakes, {.asset = entry.asset.id, .colouring = look.colouring});
}

/// Entries on their way from the threads that make them to the one that draws them.
class EntryQueue {
public:
    void push(SheetEntry entry) {
        const std::lock_guard lock(m_guard);
        m_entries.push_back(std::move(entry));
        m_hasNews.notify_one();
    }
    /// No more are to come.
    void end(Status status) {
        const std::lock_guard lock(m_guard);
        m_end = std::move(status);
        m_hasNews.notify_one();
    }
    /// Waits for the next; nothing where there is none to come.
    std::optional<SheetEntry> next() {
        std::unique_lock lock(m_guard);
        m_hasNews.wait(lock, [this] { return !m_entries.empty() || m_end; });
        if (m_entries.empty()) return std::nullopt;
        SheetEntry entry = std::move(m_entries.front());
        m_entries.pop_front();
        return entry;
    }
    const Status& status() const { return *m_end; }

private:
    std::mutex m_guard;
    std::condition_variable m_hasNews;
    std::deque<SheetEntry> m_entries;
    std::optional<Status> m_end;
};

}  // namespace

Result<SheetPainter> SheetPainter::made(const SheetOrder& order, const SheetLook& look) {
    Result<PictureMaker> maker = PictureMaker::made();
    if (!maker) return maker.error();
    return SheetPainter(std::move(*maker), order, look);
}

SheetPainter::SheetPainter(PictureMaker maker, const SheetOrder& order, const SheetLook& look)
    : m_maker(std::move(maker)), m_project(order.project), m_look(look) {
    const Box3 box = order.stage ? boundsUnderShot(order)
                                 : boundsOf(sceneOf(order.project, {}, {.asset = order.asset, .isWhole = true}));
    m_view.size = look.size;
    m_view.settings.theme = look.theme;
    m_view.settings.hasAxes = false;
    m_view.camera = framing(turned(order, look), box, look.size);
}

Result<Image> SheetPainter::pictureOf(const SheetEntry& entry, const TaskContext& task) {
    if (entry.fault) return Error{ErrorCode::BadInput, *entry.fault};
    std::shared_ptr<const RenderScene> scene;
    if (entry.moment) {
        const std::shared_ptr<const PlayScene> played(entry.moment, &entry.moment->scene());
        scene = MomentBuilder(played, {.colouring = m_look.colouring}).momentOf(*entry.moment);
    } else {
        scene = std::make_shared<const RenderScene>(sceneAtRest(m_project, entry, m_look));
    }
    return m_maker.pictureOf(std::move(scene), m_view, m_look.samples, task);
}

Status drawContactSheet(const SheetOrder& order, const SheetLook& look,
                        const std::function<void(SheetEntry, std::optional<Image>)>& take, const TaskContext& task) {
    Result<SheetPainter> painter = SheetPainter::made(order, look);
    if (!painter) return painter.error();
    EntryQueue queue;
    TaskContext making{.cancel = task.cancel, .progress = {}, .threads = task.threads};
    std::jthread maker([&] {
        queue.end(makeContactSheet(
            order, [&](SheetEntry entry) { queue.push(std::move(entry)); }, making));
    });
    Status drawn = success();
    std::size_t done = 0;
    while (std::optional<SheetEntry> entry = queue.next()) {
        if (!drawn) continue;
        std::optional<Image> picture;
        if (!entry->fault) {
            Result<Image> image = painter->pictureOf(*entry, {.cancel = task.cancel, .progress = {}});
            if (image) picture = std::move(*image);
            if (!image) drawn = image.error();
        }
        if (!drawn) {
            making.cancel.cancel();
            continue;
        }
        entry->moment = nullptr;
        take(std::move(*entry), std::move(picture));
        task.report(static_cast<double>(++done) / static_cast<double>(order.variants.size()));
    }
    return drawn ? queue.status() : drawn;
}

}  // namespace rubble
