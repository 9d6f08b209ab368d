#include "core/play/analysis/ContactSheet.h"

#include "core/asset/bake/FragmentSets.h"
#include "core/base/MessageText.h"
#include "core/base/Parallel.h"
#include "core/geometry/hull/AspectRatio.h"
#include "core/play/session/PlayTestRun.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <numeric>
#include <set>

namespace rubble {
namespace {

constexpr std::array<const char*, kSheetMeasures> kNames{"number", "pieces",      "smallestPiece",
                                                         "aspect", "breakImpact", "debrisHeight"};

/// The measures of a bake.
SheetFigures figuresOf(const Bake& bake) {
    SheetFigures figures;
    const FragmentSet leaves = leafFragments(bake);
    for (std::uint32_t k = 0; k < bake.fragmentCount(); ++k) {
        if (!leaves[k]) continue;
        const Fragment solid = bake.fragment(k).solid;
        const double volume = solid.volume();
        figures.smallestFragment = figures.fragments == 0 ? volume : std::min(figures.smallestFragment, volume);
        figures.aspect = std::max(figures.aspect, solid.aspectRatio());
        ++figures.fragments;
    }
    return figures;
}

bool isOfAsset(const Session& session, const PlayBody& body, Id asset) {
    const PlayOrigin& origin = session.origins()[body.origin];
    return origin.instance != 0 && origin.asset == asset;
}

/// Observes a session and measures the asset.
class AssetObserver {
public:
    AssetObserver(const Session& session, Id asset) : m_session(session), m_asset(asset) {}

    void afterStep() {
        for (const PlayBreak& broken : m_session.events().breaks) {
            if (isOfAsset(m_session, broken.body, m_asset) && !m_impact) m_impact = broken.impact;
        }
    }

    void measure(SheetFigures& figures) const {
        figures.breakImpact = m_impact;
        const Ground& ground = m_session.scene().project.ground;
        const double floor = ground.isOn ? ground.height : 0.0;
        for (const PlayBody& body : m_session.bodies()) {
            if (body.role != PlayRole::Debris || !isOfAsset(m_session, body, m_asset)) continue;
            const double height = topHeight(body, m_session.world()) - floor;
            figures.debrisHeight = std::max(figures.debrisHeight.value_or(height), height);
        }
    }

private:
    const Session& m_session;
    const Id m_asset;
    std::optional<double> m_impact;
};

Status checkStage(const SheetRequest& request) {
    const std::string name = quotedName(findAsset(request.project, request.asset)->name);
    if (std::ranges::find(request.project.instances, request.asset, &Instance::asset) ==
        request.project.instances.end()) {
        return Error{ErrorCode::NotFound, "The scene has no instance of " + name + " that a saved throw could hit."};
    }
    for (const Id shot : request.stage->shots) {
        if (std::ranges::find(request.project.shots, shot, &Shot::id) != request.project.shots.end()) continue;
        return Error{ErrorCode::NotFound, "The project has no saved throw " + std::to_string(shot) + "."};
    }
    return success();
}

/// The scene with the original asset; variants share everything else of it.
Result<std::shared_ptr<const PlayScene>> sharedScene(const SheetRequest& request, const TaskContext& task) {
    const Project project = projectWith(request.project, *findAsset(request.project, request.asset));
    AssetBakes bakes = request.bakes;
    std::set<Id> missing;
    for (const AssetVariant& variant : usedVariants(project)) {
        if (!bakes.contains(variant)) missing.insert(variant.asset);
    }
    if (!missing.empty()) {
        const std::vector<Id> only(missing.begin(), missing.end());
        Result<AssetBakes> rest = bakesOf(project, only, task);
        if (!rest) return rest.error();
        bakes.merge(*rest);
    }
    return playScene(project, bakes, task);
}

/// Computes the entries of one sheet.
class Sheet {
public:
    Sheet(const SheetRequest& request, std::shared_ptr<const PlayScene> shared)
        : m_request(request), m_shared(std::move(shared)) {}

    /// Errors: Cancelled.
    Result<SheetEntry> entry(std::uint32_t number, const TaskContext& task) const {
        SheetEntry made{.number = number, .asset = m_request.variants[number]};
        const Status status = fill(made, task);
        if (!status && status.error().code == ErrorCode::Cancelled) return status.error();
        if (!status) made.fault = status.error().message;
        return made;
    }

private:
    Status fill(SheetEntry& entry, const TaskContext& task) const {
        Result<Bake> baked = bake(entry.asset, task);
        if (!baked) return baked.error();
        entry.bake = std::make_shared<const Bake>(std::move(*baked));
        entry.figures = figuresOf(*entry.bake);
        return m_shared ? play(entry, task) : success();
    }

    Status play(SheetEntry& entry, const TaskContext& task) const {
        Asset asset = entry.asset;
        if (m_shared->project.damage.isThesis) asset.breakAs = BreakAs::Whole;
        const Result<std::shared_ptr<const PlayAsset>> ready = playAsset(asset, entry.bake, task);
        if (!ready) return ready.error();
        auto scene = std::make_shared<PlayScene>(*m_shared);
        scene->project = projectWith(scene->project, entry.asset);
        scene->assets[{entry.asset.id}] = *ready;
        if (const Status added = addStructures(*scene); !added) return added;
        Result<Session> session = start(entry, std::move(scene));
        if (!session) return session.error();
        const auto moved = std::make_shared<Session>(std::move(*session));
        AssetObserver observer(*moved, entry.asset.id);
        for (std::uint64_t step = 0; step < m_request.stage->step; ++step) {
            if (task.isCancelled()) return TaskContext::cancelled();
            moved->step();
            observer.afterStep();
            entry.history.add(moved->stepsDone(), moved->events());
        }
        observer.measure(entry.figures);
        entry.figures.isPlayed = true;
        entry.session = moved;
        return success();
    }

    Result<Session> start(const SheetEntry& entry, std::shared_ptr<const PlayScene> scene) const {
        const SheetStage& stage = *m_request.stage;
        const PlayTest test{.shots = stage.shots};
        if (!stage.state) return sessionOf(std::move(scene), test, {.dt = stage.stepLength});
        const Result<SavedSession> state = withBake(*stage.state, entry.asset, *entry.bake);
        if (!state) return state.error();
        return sessionOf(std::move(scene), test, {}, &*state);
    }

    const SheetRequest& m_request;
    const std::shared_ptr<const PlayScene> m_shared;  // null if nothing is played
};

}  // namespace

const char* nameOf(SheetMeasure measure) { return kNames[static_cast<std::size_t>(measure)]; }

std::optional<double> SheetFigures::value(SheetMeasure measure, std::uint32_t number) const {
    if (fragments == 0 && measure != SheetMeasure::Number) return std::nullopt;  // it could not be fractured
    switch (measure) {
        case SheetMeasure::Number: return number;
        case SheetMeasure::Fragments: return fragments;
        case SheetMeasure::SmallestFragment: return smallestFragment;
        case SheetMeasure::Aspect: return aspect;
        case SheetMeasure::BreakImpact: return breakImpact;
        case SheetMeasure::DebrisHeight: return debrisHeight;
    }
    return std::nullopt;
}

Project projectWith(const Project& project, const Asset& variant) {
    Project changed = project;
    for (Asset& asset : changed.assets) {
        if (asset.id == variant.id) asset = variant;
    }
    for (Instance& instance : changed.instances) {
        if (instance.asset == variant.id) instance.variant = 0;
    }
    return changed;
}

Status makeContactSheet(const SheetRequest& request, const std::function<void(SheetEntry)>& take,
                        const TaskContext& task) {
    if (!findAsset(request.project, request.asset)) {
        return Error{ErrorCode::NotFound, "The project has no asset " + std::to_string(request.asset) + "."};
    }
    std::shared_ptr<const PlayScene> shared;
    const TaskContext quiet{.cancel = task.cancel, .threads = task.threads};
    if (request.stage) {
        if (const Status checked = checkStage(request); !checked) return checked;
        const Result<std::shared_ptr<const PlayScene>> scene = sharedScene(request, quiet);
        if (!scene) return scene.error();
        shared = *scene;
    }
    const Sheet sheet(request, shared);
    std::mutex guard;  // guards `take` and `done`
    std::size_t done = 0;
    forEachIndex(request.variants.size(), task.threads, [&](std::size_t k) {
        if (task.isCancelled()) return;
        Result<SheetEntry> entry = sheet.entry(static_cast<std::uint32_t>(k), {.cancel = task.cancel});
        if (!entry) return;
        const std::lock_guard lock(guard);
        take(std::move(*entry));
        task.report(static_cast<double>(++done) / static_cast<double>(request.variants.size()));
    });
    if (done < request.variants.size()) return TaskContext::cancelled();
    return success();
}

std::vector<std::uint32_t> sortedBy(SheetMeasure measure, std::span<const SheetEntry> entries) {
    std::vector<std::uint32_t> numbers(entries.size());
    std::iota(numbers.begin(), numbers.end(), 0u);
    const auto valueOf = [&](std::uint32_t k) { return entries[k].figures.value(measure, entries[k].number); };
    std::ranges::stable_sort(numbers, [&](std::uint32_t one, std::uint32_t other) {
        const std::optional<double> left = valueOf(one), right = valueOf(other);
        return left && right ? *left < *right : left.has_value() && !right;
    });
    return numbers;
}

}  // namespace rubble
